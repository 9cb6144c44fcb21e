// Embree, the native tracer to measure the device against, if its development package was installed at build time.
#pragma once

#include "bench/ray_tracer.h"

#include <memory>

namespace hyalite::bench {

// E.g. "Embree 3.13.5"; empty if built without Embree.
[[nodiscard]] std::string embreeVersion();

// Embree, one ray at a time on all cores, with a high-quality hierarchy over the scene's meshes and quads; nullptr
// without Embree, or if the scene has other shapes.
[[nodiscard]] std::unique_ptr<RayTracer> makeEmbreeTracer(const Scene& scene);

} // namespace hyalite::bench
