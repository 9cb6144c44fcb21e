// Photon mapping with final gathering against the unbiased path tracer of the reference.
#include "kernel/kernel_support.h"
#include "render/integrators/registry.h"
#include "render/renderer.h"
#include "scene/load/load_scene.h"

#include <filesystem>

namespace hyalite::testing {

namespace {

Scene shipped(const std::string& name) {
    return loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes" / name);
}

// The room behind the gap, with a clay ball in place of the glass one: no caustics.
Scene roomWithoutGlass() {
    Scene scene = shipped("room-through-gap.yaml");
    for (Object& object : scene.objects) {
        if (object.material && scene.materials[*object.material].model.type == shared::kMaterialDielectric) {
            object.material = 0;
        }
    }
    return scene;
}

// Three balls in a corner, under a sun and a sky.
Scene ballsOutdoors() {
    Scene scene = reference::test::onePixel({0, 2, 6}, {0, 0.5, 0}, "photonmap");
    scene.camera.fov = 40;
    const std::size_t light = reference::test::addMaterial(scene, Diffuse{{0.7, 0.7, 0.6}});
    const std::size_t red = reference::test::addMaterial(scene, Diffuse{{0.7, 0.2, 0.1}});
    reference::test::addObject(scene, Quad{{-4, 0, 4}, {8, 0, 0}, {0, 0, -8}}, light);
    reference::test::addObject(scene, Quad{{-4, 0, -4}, {8, 0, 0}, {0, 4, 0}}, light);
    for (const double x : {-1.2, 0.0, 1.2}) {
        reference::test::addObject(scene, Sphere{{x, 0.5, -0.5 * x}, 0.5}, x == 0 ? light : red);
    }
    Environment sky;
    sky.image = Image(1, 1);
    sky.image.pixels = {{0.5F, 0.7F, 1.0F}};
    scene.environment = sky;
    scene.directionals.push_back({.direction = glm::normalize(dvec3(-1, -2, -1)), .irradiance = dvec3(3, 2.8, 2.4)});
    scene.render.photons = 200000;
    return scene;
}

dvec3 meanOf(const Image& image) {
    dvec3 sum(0);
    for (const vec3& pixel : image.pixels) {
        sum += dvec3(pixel);
    }
    return sum / static_cast<double>(image.pixels.size());
}

} // namespace

TEST_CASE("without caustics, final gathering is as bright as path tracing to 2 %") {
    const std::vector<std::pair<std::string, Scene>> scenes{{"Cornell box", shipped("cornell-box.yaml")},
                                                            {"room behind a gap", roomWithoutGlass()},
                                                            {"balls outdoors", ballsOutdoors()}};
    for (auto [name, scene] : scenes) {
        scene.camera.resolution = {32, 32};
        scene.render.maxDepth = 32;
        scene.render.integrator = "photonmap";
        scene.render.passes = 32;
        scene.render.photonMap.gatherRays = 2;
        const Image photonMap =
            render::render(Gpu::shared().context(), Gpu::shared().compiler(), scene, {}).image.picture;
        scene.render.integrator = "path";
        scene.render.passes = 256;
        const Image path = render::renderByReference(scene).picture;
        INFO(name);
        const dvec3 ratio = meanOf(photonMap) / meanOf(path);
        // Paths deviate by a few times their mean: the mean of 262 144 paths is accurate to half a percent
        for (const double channel : {ratio.x, ratio.y, ratio.z}) {
            CHECK(std::abs(channel - 1) < 0.02);
        }
    }
}

} // namespace hyalite::testing
