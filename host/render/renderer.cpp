#include "render/renderer.h"

#include "base/stopwatch.h"
#include "render/film/scene_identity.h"
#include "render/integrators/registry.h"
#include "render/upload/custom_code.h"
#include "render/wavefront/learn_lights.h"

#include <bit>

namespace hyalite::render {

namespace {

void finishPicture(Device& device, Film& film, RenderResult& result) {
    result.image = film.resolve(device);
    result.errorEstimate = film.estimateError(device);
    result.passes = film.passes().count();
    result.faults = film.faults();
    result.layers = film.layers();
}

// Renders the requested passes that the film does not have yet, and records the results.
void renderPasses(Device& device, const Scene& scene, const RenderOptions& options, Film& film,
                  PassIntegrator& integrator, Checkpointing& checkpointing, RenderResult& result) {
    const PassRange range{options.firstPass, options.firstPass + scene.render.passes};
    result.resumedFrom = film.passes().count();
    Progress progress;
    progress.passes = result.resumedFrom;
    progress.ofPasses = result.resumedFrom + scene.render.passes - film.passes().countWithin(range);
    progress.resumedFrom = result.resumedFrom;
    const auto lookAtError = [&] {
        if (looksAtError(progress.passes)) {
            progress.errorEstimate = film.estimateError(device).error;
        }
    };
    lookAtError();
    const Stopwatch passes;
    bool begun = false;
    for (std::uint32_t pass = range.begin; progress.passes < progress.ofPasses; ++pass) {
        if (film.passes().contains(pass)) {
            continue;
        }
        result.stopped = options.stop && options.stop();
        if (result.stopped || !timeForAnotherPass(progress, options.timeLimit) ||
            reachesTarget(progress, scene.render.targetError)) {
            break;
        }
        if (!begun) {
            integrator.begin();
            begun = true;
        }
        film.beginPass(pass);
        integrator.renderPass(pass);
        film.endPass();
        ++progress.passes;
        lookAtError();
        progress.seconds = passes.seconds();
        checkpointing.save(film, integrator.counts(), progress.seconds, /*now*/ false);
        if (options.onPass) {
            options.onPass(progress);
        }
    }
    result.renderSeconds = progress.seconds;
    if (progress.passes == 0) {
        throw Error(ExitCode::Interrupted, "interrupted before the first pass finished: there is no picture");
    }
    if (progress.passes > progress.resumedFrom) {
        checkpointing.save(film, integrator.counts(), progress.seconds, /*now*/ true);
    }
    result.checkpointFailure = checkpointing.failure();
    finishPicture(device, film, result);
}

} // namespace

bool timeForAnotherPass(const Progress& progress, double timeLimit) {
    const std::uint32_t passes = progress.passes - progress.resumedFrom;
    return timeLimit <= 0 || progress.passes == 0 || passes == 0 || progress.seconds * (1 + 1.0 / passes) <= timeLimit;
}

bool looksAtError(std::uint32_t passes) {
    constexpr std::uint32_t kParts = 8;
    return passes >= kPassesToBelieve && passes % (std::bit_floor(passes) / kParts) == 0;
}

bool reachesTarget(const Progress& progress, double targetError) {
    return targetError > 0 && looksAtError(progress.passes) && progress.errorEstimate &&
           *progress.errorEstimate <= targetError;
}

RenderResult render(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                    const RenderOptions& options) {
    const Stopwatch setup;
    gpu::ShaderCompiler withCustomCode(compiler);
    withCustomCode.replace(customCode(scene));
    Device device(context, withCustomCode, options.profile);
    DeviceScene deviceScene = uploadScene(context, device.tables, scene);
    const IntegratorKind& kind = integratorKind(scene);
    Film film(device, scene.camera.resolution, kind.layers(scene.render));
    const auto integrator = kind.make({.device = device,
                                       .scene = scene,
                                       .deviceScene = deviceScene,
                                       .film = film,
                                       .photonFiles = options.photonFiles});
    learnLights(device, scene, deviceScene);
    integrator->prepare();
    if (options.onUpload) {
        options.onUpload(device, deviceScene);
    }

    RenderResult result;
    result.setupSeconds = setup.seconds();
    const bool kept = !options.checkpoint.file.empty();
    Checkpointing checkpointing(options.checkpoint,
                                kept ? identify(scene, deviceScene, withCustomCode) : RenderIdentity());
    checkpointing.resume(device, film);
    renderPasses(device, scene, options, film, *integrator, checkpointing, result);
    result.memory = context.memory();
    result.counts = integrator->counts();
    result.counts += checkpointing.countsBefore();
    result.notes = integrator->notes();
    result.stages = device.commands.times();
    return result;
}

RenderResult resolve(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const FilmState& state) {
    Device device(context, compiler, false);
    Film film(device, state.resolution, state.layers);
    film.restore(device, state);
    RenderResult result;
    finishPicture(device, film, result);
    return result;
}

} // namespace hyalite::render
