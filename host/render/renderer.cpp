#include "render/renderer.h"

#include "base/stopwatch.h"
#include "render/custom_code.h"
#include "render/path.h"
#include "render/photon_mapping.h"
#include "render/ppm.h"
#include "render/whitted.h"

#include <bit>

namespace hyalite::render {

std::vector<LayerKind> layersOf(const Scene& scene) {
    switch (scene.render.integrator) {
    case Integrator::Whitted:
        return Whitted::layers();
    case Integrator::Ppm:
        return Ppm::layers();
    case Integrator::PhotonMap:
        return PhotonMapping::layers(scene.render.photonMap.view);
    case Integrator::Path:
        return PathTracing::layers();
    }
    return {};
}

std::unique_ptr<PassIntegrator> makeIntegrator(Device& device, const Scene& scene, const DeviceScene& deviceScene,
                                               const Film& film, const RenderOptions& options) {
    switch (scene.render.integrator) {
    case Integrator::Whitted:
        return std::make_unique<Whitted>(device, scene, deviceScene, film);
    case Integrator::Ppm:
        return std::make_unique<Ppm>(device, scene, deviceScene, film);
    case Integrator::PhotonMap:
        return std::make_unique<PhotonMapping>(device, scene, deviceScene, film, options);
    case Integrator::Path:
        return std::make_unique<PathTracing>(device, scene, deviceScene, film);
    }
    return nullptr;
}

bool timeForAnotherPass(const Progress& progress, double timeLimit) {
    return timeLimit <= 0 || progress.passes == 0 || progress.seconds * (1 + 1.0 / progress.passes) <= timeLimit;
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
    const DeviceScene deviceScene = uploadScene(context, device.tables, scene);
    Film film(device, scene.camera.resolution, layersOf(scene));
    const auto integrator = makeIntegrator(device, scene, deviceScene, film, options);

    if (options.onUpload) {
        options.onUpload(device, deviceScene);
    }

    RenderResult result;
    result.setupSeconds = setup.seconds();
    const Stopwatch passes;
    Progress progress{.passes = 0, .ofPasses = scene.render.passes, .seconds = 0, .errorEstimate = std::nullopt};
    while (progress.passes < progress.ofPasses && timeForAnotherPass(progress, options.timeLimit) &&
           !reachesTarget(progress, scene.render.targetError)) {
        film.beginPass(progress.passes);
        integrator->renderPass(options.firstPass + progress.passes);
        ++progress.passes;
        if (looksAtError(progress.passes)) {
            progress.errorEstimate = film.estimateError(device, progress.passes);
        }
        progress.seconds = passes.seconds();
        if (options.onPass) {
            options.onPass(progress);
        }
    }
    result.memory = context.memory();
    result.image = film.resolve(device, progress.passes);
    result.errorEstimate = film.estimateError(device, progress.passes);
    result.passes = progress.passes;
    result.renderSeconds = progress.seconds;
    result.counts = integrator->counts();
    result.notes = integrator->notes();
    result.stages = device.commands.times();
    return result;
}

} // namespace hyalite::render
