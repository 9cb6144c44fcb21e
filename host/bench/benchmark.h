// Measures every stage of a renderer on one scene, and the cost of compiling each kernel.
#pragma once

#include "bench/timing.h"
#include "gpu/context.h"
#include "gpu/shader_compiler.h"
#include "scene/model/scene.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace hyalite::bench {

// The stages, in the order of measurement:
//   scene      build and upload of the scene's hierarchies and tables      [objects and triangles of meshes]
//   camera     closest hits of camera rays                                 [rays]
//   shadow     shadow rays from there to the lights                        [rays]
//   bounce     closest hits of the rays that continue from there           [rays]
//   shuffled   the same rays in random order                               [rays]
//   photons    photon paths, from emission to the last stored photon       [photons emitted]
//   grid       photons sorted into a grid                                  [photons stored]
//   gather     gather_radiance with ppm's radius                           [visible points]
//   tree       photons sorted into a kd-tree                               [photons stored]
//   estimate   estimate_radiance among the 50 nearest                      [visible points]
//   start      the scene's own integrator: set-up and the first pass, once [pictures]
//   render     each pass after it                                          [passes]
[[nodiscard]] const std::vector<std::string>& stageNames();

struct BenchOptions {
    int runs = 7;
    std::set<std::string> stages; // to measure; empty: all
    std::uint32_t photons = 200000;
    std::filesystem::path against; // other shaders to measure alternately; empty: none

    [[nodiscard]] bool wants(const std::string& stage) const { return stages.empty() || stages.contains(stage); }
};

// Another tracer of the same rays, run alternately with the device.
struct Rival {
    std::string name;
    std::vector<Run> runs;
    double ratio = 0;      // the device's speed over the rival's: median over pairs of runs
    double coresRatio = 0; // the same ratio by core time
    double agreeing = 0;   // fraction of rays that end at the same point
};

struct StageResult {
    std::string stage;
    std::string unit;
    std::uint64_t count = 0; // of units in one run
    std::vector<Run> runs;
    std::vector<Rival> rivals;
};

struct SceneResult {
    std::string scene;
    std::uint64_t objects = 0;
    std::uint64_t triangles = 0; // of meshes, each counted once
    std::vector<StageResult> stages;
};

[[nodiscard]] SceneResult measureScene(const gpu::Context& context, const gpu::ShaderCompiler& compiler,
                                       const Scene& scene, const BenchOptions& options);

struct KernelResult {
    std::string kernel;
    double compileSeconds = 0;  // GLSL to SPIR-V, without the cache
    double pipelineSeconds = 0; // from SPIR-V in the compiler's cache, if it has one, to a pipeline
    double firstSeconds = 0;    // a first, empty dispatch: there lavapipe compiles what its own cache does not hold
};

// Measures every kernel of the compiler's folder once, not specialised to a scene.
[[nodiscard]] std::vector<KernelResult> measureKernels(const gpu::Context& context,
                                                       const gpu::ShaderCompiler& compiler);

} // namespace hyalite::bench
