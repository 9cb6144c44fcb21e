#include "transport/rendering.h"

#include "render/integrators/registry.h"
#include "render/upload/device_scene.h"
#include "support/gpu_fixture.h"

#include "shaders/shared/materials.h"

#include <algorithm>

namespace hyalite::testing {

namespace {

// One for the program, so that kernels outlive a scene; it ends before the context that it uses.
render::Device& sharedDevice() {
    static Gpu& gpu = Gpu::shared();
    static render::Device device(gpu.context(), gpu.compiler(), false);
    return device;
}

// Constants for which kernels are right for this scene and for most others.
gpu::Specialization widened(gpu::Specialization constants) {
    constexpr std::uint32_t kAll = ~0U;
    constants["kShapeTypes"] = kAll;
    // The integrators keep points of rough surfaces only if the scene has any
    constants["kMaterialTypes"] |= kAll & ~(1U << shared::kMaterialRough);
    constants["kLightTypes"] = kAll;
    constants["kFewObjects"] = 0; // through the hierarchy, which every scene has
    constants["kStackEntries"] = std::max(constants["kStackEntries"], 32U);
    constants["kCsgLeaves"] = std::max(constants["kCsgLeaves"], 4U);
    return constants;
}

std::vector<Image> onDevice(Scene& scene, std::uint32_t first, std::uint32_t count) {
    render::Device& device = sharedDevice();
    for (std::uint32_t binding = 0; binding < TABLE_COUNT; ++binding) { // the last scene's buffers are gone
        device.tables.set(binding, {}, gpu::TexelFormat::Float4);
    }
    render::DeviceScene deviceScene = render::uploadScene(device.context, device.tables, scene);
    deviceScene.specialization = widened(deviceScene.specialization);
    const render::IntegratorKind& kind = render::integratorKind(scene);
    render::Film film(device, scene.camera.resolution, kind.layers(scene.render));
    device.commands.finish();
    const render::FilmState black = film.state();
    // The integrator and its stages read the seed from the scene; begin() replaces all that it built before
    const auto integrator = kind.make({.device = device, .scene = scene, .deviceScene = deviceScene, .film = film});
    integrator->prepare();
    std::vector<Image> pictures;
    for (std::uint32_t seed = first; seed < first + count; ++seed) {
        scene.render.seed = seed;
        film.restore(device, black);
        integrator->begin();
        for (std::uint32_t pass = 0; pass < scene.render.passes; ++pass) {
            film.beginPass(pass);
            integrator->renderPass(pass);
            film.endPass();
        }
        pictures.push_back(film.resolve(device).picture);
        device.commands.finish();
    }
    return pictures;
}

} // namespace

std::vector<Image> renderSeeds(const Renderer& renderer, Scene scene, std::uint32_t first, std::uint32_t count) {
    scene.render.integrator = renderer.integrator;
    if (renderer.backend == Backend::Vulkan) {
        return onDevice(scene, first, count);
    }
    std::vector<Image> pictures;
    for (std::uint32_t seed = first; seed < first + count; ++seed) {
        scene.render.seed = seed;
        pictures.push_back(render::renderByReference(scene).picture);
    }
    return pictures;
}

double meanOf(const Image& image) {
    double sum = 0;
    for (const glm::vec3& pixel : image.pixels) {
        sum += double{pixel.x};
    }
    return sum / static_cast<double>(image.pixels.size());
}

} // namespace hyalite::testing
