// Interface of what traces a set of rays: the device with its kernels, or a native tracer.
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

    // Sets the rays for the following calls of trace().
    virtual void load(const RaySet& set) = 0;
    // Traces all rays; this is the timed part.
    virtual void trace() = 0;
    // For each ray, the distance to its hit in units of its direction; infinity without a hit. Shadow rays: 0 if
    // occluded.
    [[nodiscard]] virtual std::vector<float> ends() const = 0;
};

} // namespace hyalite::bench
