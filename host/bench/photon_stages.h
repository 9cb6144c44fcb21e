// The cost of a pass's photons: to trace them, to sort them into a grid or a tree, and to gather them.
#pragma once

#include "bench/benchmark.h"
#include "render/upload/device_scene.h"
#include "render/wavefront/device.h"

namespace hyalite::bench {

// Measures the stages photons, grid, gather, tree and estimate, as far as the options want them.
void measurePhotonStages(render::Device& device, const Scene& scene, const render::DeviceScene& deviceScene,
                         const BenchOptions& options, SceneResult& result);

} // namespace hyalite::bench
