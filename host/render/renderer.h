// Renders a scene on the device: set-up, the loop over passes, and what it took.
#pragma once

#include "gpu/commands.h"
#include "gpu/shader_compiler.h"
#include "image/layered_image.h"
#include "render/film/checkpointing.h"
#include "render/integrators/integrator.h"
#include "render/upload/device_scene.h"
#include "scene/model/scene.h"

#include <functional>
#include <optional>

namespace hyalite::render {

struct Progress {
    std::uint32_t passes = 0;            // done, with those resumed from
    std::uint32_t ofPasses = 0;          // that there will be
    double seconds = 0;                  // since the first pass began
    std::optional<double> errorEstimate; // when last looked at, see looksAtError
    std::uint32_t resumedFrom = 0;       // passes done before the first
};

struct RenderOptions {
    bool profile = false;        // time every stage
    std::uint32_t firstPass = 0; // its number
    double timeLimit = 0;        // start no pass that would probably end later than this [s]; 0: no limit
    std::function<void(const Progress&)> onPass; // after every pass
    std::function<bool()> stop;                  // asked before every pass: whether there shall be no more
    CheckpointOptions checkpoint;
    // Once, before anything that belongs to the picture is computed: may have the device's commands observed
    std::function<void(Device&, const DeviceScene&)> onUpload;
    PhotonFiles photonFiles;
};

struct RenderResult {
    LayeredImage image;
    std::uint32_t passes = 0;               // in the picture
    std::uint32_t resumedFrom = 0;          // of these, so many were in the checkpoint
    bool stopped = false;                   // passes are missing because `stop` said so
    std::vector<FilmFault> faults;          // see FilmState
    std::vector<LayerKind> layers;          // of the film
    std::optional<Error> checkpointFailure; // the last checkpoint could not be written
    double setupSeconds = 0;                // kernels, scene, hierarchies
    double renderSeconds = 0;               // passes
    std::optional<double> errorEstimate;    // of the picture, see docs/metrics.md; none of a single pass
    Counts counts;
    RenderNotes notes;
    std::map<std::string, std::size_t> memory;    // bytes of the device's buffers after the last pass, by name
    std::map<std::string, gpu::StageTime> stages; // with profile
};

// Renders scene.render.passes passes, but for those that the checkpoint holds, fewer where the time limit or the target
// error comes first (one at least). Throws Error(Device) when the device has no room for the scene or fails,
// Error(Interrupted) when it is stopped before there is a pass to show.
[[nodiscard]] RenderResult render(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                                  const RenderOptions& options);

// The picture and its error, in the same bits as if this device had rendered all passes of the film.
[[nodiscard]] RenderResult resolve(const gpu::Context& context, const gpu::ShaderCompiler& compiler,
                                   const FilmState& film);

// Whether a pass that takes as long as the passes before it on average would end within `timeLimit` [s]; 0: always.
[[nodiscard]] bool timeForAnotherPass(const Progress& progress, double timeLimit);

// Whether to estimate the error after so many passes: every 8th to 16th part of them, whatever time they took, so that
// estimates cost little beside the passes, and the same scene stops at the same pass on every machine. Not before
// kPassesToBelieve passes: what few paths find (a caustic, a lamp in a mirror) shows in the variance only once some
// have found it.
inline constexpr std::uint32_t kPassesToBelieve = 16;
[[nodiscard]] bool looksAtError(std::uint32_t passes);

// Whether the error was estimated after the last pass and is no larger than what was asked for; never where that is 0.
[[nodiscard]] bool reachesTarget(const Progress& progress, double targetError);

} // namespace hyalite::render
