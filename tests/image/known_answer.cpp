#include "image/known_answer.h"

#include "render/integrators/ppm/ppm.h"
#include "render/integrators/registry.h"
#include "render/renderer.h"
#include "render/upload/device_scene.h"
#include "scene/model/integrators.h"
#include "support/gpu_fixture.h"

#include <algorithm>
#include <numeric>

namespace hyalite::testing {

const std::vector<Renderer>& everyRenderer() {
    static const std::vector<Renderer> all = [] {
        std::vector<Renderer> renderers;
        for (const std::string_view name : kIntegratorNames) {
            renderers.push_back({std::string(name) + ", vulkan", name, Backend::Vulkan});
            renderers.push_back({std::string(name) + ", reference", name, Backend::Reference});
        }
        return renderers;
    }();
    return all;
}

std::vector<Renderer> renderersOf(std::span<const std::string_view> integrators) {
    std::vector<Renderer> chosen;
    std::ranges::copy_if(everyRenderer(), std::back_inserter(chosen), [&](const Renderer& renderer) {
        return std::ranges::find(integrators, renderer.integrator) != integrators.end();
    });
    return chosen;
}

Image renderBy(const Renderer& renderer, Scene scene) {
    scene.render.integrator = renderer.integrator;
    if (renderer.backend == Backend::Reference) {
        return render::renderByReference(scene).picture;
    }
    return render::render(Gpu::shared().context(), Gpu::shared().compiler(), scene, {}).image.picture;
}

ExpectedPixel everywhere(double radiance) {
    return [radiance](int, int) { return radiance; };
}

std::vector<double> pixelRatios(const Image& image, const ExpectedPixel& expected) {
    std::vector<double> ratios;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            ratios.push_back(double{image.at(x, y).x} / expected(x, y));
        }
    }
    return ratios;
}

namespace {

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Renders by ppm on the device without recreating its kernels for each render. The integrator and its stages read the
// seed from the scene at every pass.
std::vector<double> progressiveRatios(Scene scene, std::uint32_t renders, const ExpectedPixel& expected) {
    render::Device device(Gpu::shared().context(), Gpu::shared().compiler(), false);
    const render::DeviceScene deviceScene = render::uploadScene(device.context, device.tables, scene);
    const render::IntegratorKind kind = render::Ppm::kind();
    render::Film film(device, scene.camera.resolution, kind.layers(scene.render));
    const auto ppm = kind.make({.device = device, .scene = scene, .deviceScene = deviceScene, .film = film});
    ppm->prepare();
    device.commands.finish();
    const render::FilmState black = film.state();
    std::vector<double> means;
    for (std::uint32_t seed = 1; seed <= renders; ++seed) {
        scene.render.seed = seed;
        film.restore(device, black);
        for (std::uint32_t pass = 0; pass < scene.render.passes; ++pass) {
            film.beginPass(pass);
            ppm->renderPass(pass);
            film.endPass();
        }
        means.push_back(meanOf(pixelRatios(film.resolve(device).picture, expected)));
    }
    return means;
}

} // namespace

std::vector<double> renderRatios(const Renderer& renderer, Scene scene, std::uint32_t renders,
                                 const ExpectedPixel& expected) {
    if (renderer.backend == Backend::Vulkan && renderer.integrator == "ppm") {
        scene.render.integrator = "ppm";
        return progressiveRatios(scene, renders, expected);
    }
    std::vector<double> means;
    for (std::uint32_t seed = 1; seed <= renders; ++seed) {
        scene.render.seed = seed;
        means.push_back(meanOf(pixelRatios(renderBy(renderer, scene), expected)));
    }
    return means;
}

Verdict judge(FalseAlarms& alarms, const Renderer& renderer, const Scene& scene, const ExpectedPixel& expected,
              Independent independent, const Sharpness& sharpness) {
    const bool sharesPhotons = integratorNamed(renderer.integrator).reads("photons");
    if (independent == Independent::Pixels || !sharesPhotons) {
        return alarms.mean(pixelRatios(renderBy(renderer, scene), expected), 1, sharpness);
    }
    constexpr std::uint32_t kRenders = 16;
    if (renderer.backend == Backend::Vulkan && renderer.integrator == "photonmap") {
        const Renderer twin{"", renderer.integrator, Backend::Reference};
        Scene another = scene;
        another.render.seed = kRenders + 1;
        const double sample = meanOf(pixelRatios(renderBy(renderer, another), expected));
        return alarms.draw(sample, renderRatios(twin, scene, kRenders, expected), 1, sharpness);
    }
    return alarms.mean(renderRatios(renderer, scene, kRenders, expected), 1, sharpness);
}

} // namespace hyalite::testing
