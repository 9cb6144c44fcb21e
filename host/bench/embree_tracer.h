// The native tracer that the device is measured against, where its development package was there when this was built.
#pragma once

#include "bench/ray_tracer.h"

#include <memory>

namespace hyalite::bench {

// "Embree 3.13.5", or empty where this was built without it.
[[nodiscard]] std::string embreeVersion();

// Embree, one ray at a time on all cores, over the scene's meshes and quads in a hierarchy of high quality; nullptr
// where there is no Embree, or where the scene holds shapes of other kinds.
[[nodiscard]] std::unique_ptr<RayTracer> makeEmbreeTracer(const Scene& scene);

} // namespace hyalite::bench
