// What the photons of a pass cost: to trace, to sort into a grid or a tree, and to gather.
#pragma once

#include "bench/benchmark.h"
#include "render/upload/device_scene.h"
#include "render/wavefront/device.h"

namespace hyalite::bench {

// Measures those of the stages photons, grid, gather, tree and estimate that are wanted.
void measurePhotonStages(render::Device& device, const Scene& scene, const render::DeviceScene& deviceScene,
                         const BenchOptions& options, SceneResult& result);

} // namespace hyalite::bench
