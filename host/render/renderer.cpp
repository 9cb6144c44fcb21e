#include "render/renderer.h"

#include "base/stopwatch.h"
#include "render/ppm.h"
#include "render/whitted.h"

namespace hyalite::render {

namespace {

std::vector<LayerKind> layersOf(Integrator integrator) {
    switch (integrator) {
    case Integrator::Whitted:
        return Whitted::layers();
    case Integrator::Ppm:
        return Ppm::layers();
    }
    throw Error(ExitCode::WrongUsage, "unknown integrator");
}

std::unique_ptr<PassIntegrator> makeIntegrator(Device& device, const Scene& scene, const DeviceScene& deviceScene,
                                               const Film& film) {
    switch (scene.render.integrator) {
    case Integrator::Whitted:
        return std::make_unique<Whitted>(device, scene, deviceScene, film);
    case Integrator::Ppm:
        return std::make_unique<Ppm>(device, scene, deviceScene, film);
    }
    throw Error(ExitCode::WrongUsage, "unknown integrator");
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
    const Film film(device, scene.camera.resolution, layersOf(scene.render.integrator));
    const auto integrator = makeIntegrator(device, scene, deviceScene, film);

    RenderResult result;
    result.setupSeconds = setup.seconds();
    const Stopwatch passes;
    Progress progress{0, scene.render.passes, 0};
    while (progress.passes < progress.ofPasses && timeForAnotherPass(progress, options.timeLimit)) {
        integrator->renderPass(progress.passes);
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
    result.stages = device.commands.times();
    return result;
}

} // namespace hyalite::render
