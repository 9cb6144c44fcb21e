// Whatever can trace a set of rays: the device with its kernels, or a native tracer beside it.
#pragma once

#include "bench/ray_sets.h"

#include <vector>

namespace hyalite::bench {

class RayTracer {
public:
    RayTracer() = default;
    RayTracer(const RayTracer&) = delete;
    RayTracer& operator=(const RayTracer&) = delete;
    virtual ~RayTracer() = default;

    // Makes the rays those that are traced from now on.
    virtual void load(const RaySet& set) = 0;
    // Traces them all: the part that is timed.
    virtual void trace() = 0;
    // Of each ray: where it ended, in units of its direction; infinity where it hit nothing. Shadow rays: 0 where
    // something blocked it.
    [[nodiscard]] virtual std::vector<float> ends() const = 0;
};

} // namespace hyalite::bench
