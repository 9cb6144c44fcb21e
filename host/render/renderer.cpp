#include "render/renderer.h"

#include "base/stopwatch.h"
#include "render/photon_mapping.h"
#include "render/ppm.h"
#include "render/whitted.h"

namespace hyalite::render {

namespace {

std::vector<LayerKind> layersOf(const RenderSettings& render) {
    switch (render.integrator) {
    case Integrator::Whitted:
        return Whitted::layers();
    case Integrator::Ppm:
        return Ppm::layers();
    case Integrator::PhotonMap:
        return PhotonMapping::layers(render.photonMap.view);
    case Integrator::Path:
        break;
    }
    throw Error(ExitCode::WrongUsage, "this integrator has no kernels");
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
        break;
    }
    throw Error(ExitCode::WrongUsage, "this integrator has no kernels");
}

} // namespace

bool timeForAnotherPass(const Progress& progress, double timeLimit) {
    return timeLimit <= 0 || progress.passes == 0 || progress.seconds * (1 + 1.0 / progress.passes) <= timeLimit;
}

RenderResult render(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                    const RenderOptions& options) {
    const Stopwatch setup;
    Device device(context, compiler, options.profile);
    const DeviceScene deviceScene = uploadScene(context, device.tables, scene);
    const Film film(device, scene.camera.resolution, layersOf(scene.render));
    const auto integrator = makeIntegrator(device, scene, deviceScene, film, options);

    if (options.onUpload) {
        options.onUpload(device, deviceScene);
    }

    RenderResult result;
    result.setupSeconds = setup.seconds();
    const Stopwatch passes;
    Progress progress{0, scene.render.passes, 0};
    while (progress.passes < progress.ofPasses && timeForAnotherPass(progress, options.timeLimit)) {
        integrator->renderPass(options.firstPass + progress.passes);
        ++progress.passes;
        progress.seconds = passes.seconds();
        if (options.onPass) {
            options.onPass(progress);
        }
    }
    result.image = film.resolve(device, progress.passes);
    result.passes = progress.passes;
    result.renderSeconds = progress.seconds;
    result.counts = integrator->counts();
    result.notes = integrator->notes();
    result.stages = device.commands.times();
    return result;
}

} // namespace hyalite::render
