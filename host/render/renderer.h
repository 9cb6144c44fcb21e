// Renders a scene on the device: set-up, the loop over passes, and their cost.
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
    std::uint32_t passes = 0;            // finished passes, including those resumed from
    std::uint32_t ofPasses = 0;          // total number of passes
    double seconds = 0;                  // since the first pass began
    std::optional<double> errorEstimate; // last estimate, see looksAtError
    std::uint32_t resumedFrom = 0;       // passes that the checkpoint already had
};

struct RenderOptions {
    bool profile = false;        // time every stage
    std::uint32_t firstPass = 0; // number of the first pass
    double timeLimit = 0;        // no pass starts that would probably end later than this [s]; 0: no limit
    std::function<void(const Progress&)> onPass; // after every pass
    std::function<bool()> stop;                  // called before every pass; true: render no more passes
    CheckpointOptions checkpoint;
    // Called once, before any part of the picture is computed; may register observers of the device's commands
    std::function<void(Device&, const DeviceScene&)> onUpload;
    PhotonFiles photonFiles;
};

struct RenderResult {
    LayeredImage image;
    std::uint32_t passes = 0;               // in the picture
    std::uint32_t resumedFrom = 0;          // number of these from the checkpoint
    bool stopped = false;                   // passes are missing because `stop` returned true
    std::vector<FilmFault> faults;          // see FilmState
    std::vector<LayerKind> layers;          // layers of the film
    std::optional<Error> checkpointFailure; // the last checkpoint could not be written
    double setupSeconds = 0;                // kernels, scene, hierarchies
    double renderSeconds = 0;               // passes
    ErrorEstimate errorEstimate;            // of the picture
    Counts counts;
    RenderNotes notes;
    std::map<std::string, std::size_t> memory;    // bytes of the device's buffers after the last pass, by name
    std::map<std::string, gpu::StageTime> stages; // with profile
};

// Renders scene.render.passes passes, except those in the checkpoint; fewer if the time limit or the target error is
// reached first (but at least one). Throws Error(Device) if the device has no room for the scene or fails,
// Error(Interrupted) if it is stopped before the first pass finishes.
[[nodiscard]] RenderResult render(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                                  const RenderOptions& options);

// The picture and its error, with the same bits as if this device had rendered all passes of the film.
[[nodiscard]] RenderResult resolve(const gpu::Context& context, const gpu::ShaderCompiler& compiler,
                                   const FilmState& film);

// Would another pass, with the average time of the passes so far, end within `timeLimit` [s]? 0: always.
[[nodiscard]] bool timeForAnotherPass(const Progress& progress, double timeLimit);

// Should the error be estimated after this many passes? It is estimated every time their number has grown by an eighth
// to a sixteenth, whatever the time they took, so that estimates cost little beside the passes, and the same scene
// stops at the same pass on every machine. Not before kPassesToBelieve passes: features that few paths find (a caustic,
// a light in a mirror) show in the variance only once some path has found them.
inline constexpr std::uint32_t kPassesToBelieve = 16;
[[nodiscard]] bool looksAtError(std::uint32_t passes);

// Was the error estimated after the last pass, and is it at most `targetError`? Never if that is 0.
[[nodiscard]] bool reachesTarget(const Progress& progress, double targetError);

} // namespace hyalite::render
