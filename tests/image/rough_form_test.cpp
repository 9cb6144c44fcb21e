// Rough and metallic surfaces in scenes whose radiance is known analytically or as an integral over the hemisphere.
#include "image/known_answer.h"
#include "kernel/kernel_support.h"
#include "reference/bsdf/bsdf.h"
#include "render/renderer.h"

namespace hyalite::testing {

namespace {

using std::numbers::pi;

vec3 onDevice(const Scene& scene) {
    return render::render(Gpu::shared().context(), Gpu::shared().compiler(), scene, {}).image.picture.pixels.at(0);
}

// The pixel sees a disk of the material about the origin, at 45 degrees; all around is an emitting room.
Scene glowingRoom(const MaterialModel& model) {
    Scene scene = reference::test::onePixel({1, 1, 0}, {0, 0, 0}, "whitted");
    scene.camera.resolution = {16, 16};
    scene.camera.up = {0, 1, 0};
    const std::size_t material = reference::test::addMaterial(scene, model);
    reference::test::addObject(scene, Disk{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, material); // faces up
    const auto wall = [&](const dvec3& corner, const dvec3& edge0, const dvec3& edge1) {
        reference::test::addObject(scene, Quad{corner, edge0, edge1}, std::nullopt, dvec3(1));
    };
    wall({-3, -3, -3}, {0, 0, 6}, {6, 0, 0}); // the walls' fronts are inside
    wall({-3, 3, -3}, {6, 0, 0}, {0, 0, 6});
    wall({-3, -3, -3}, {6, 0, 0}, {0, 6, 0});
    wall({-3, -3, 3}, {0, 6, 0}, {6, 0, 0});
    wall({-3, -3, -3}, {0, 6, 0}, {0, 0, 6});
    wall({3, -3, -3}, {0, 0, 6}, {0, 6, 0});
    scene.render.maxDepth = 2;
    scene.render.minWeight = 0;
    return scene;
}

// The integral of f cos over the sphere, seen at 45 degrees: the radiance in a room of radiance 1.
dvec3 albedoAt45(const MaterialModel& model) {
    const reference::Lobe lobe = reference::lobeOf(model, true).value();
    const reference::ShadingNormals up{{0, 0, 1}, {0, 0, 1}};
    const dvec3 wo = dvec3(1, 0, 1) / std::sqrt(2.0);
    dvec3 sum(0);
    constexpr int kRows = 1000;
    for (int i = 0; i < kRows; ++i) {
        const double z = -1 + 2 * (i + 0.5) / kRows;
        for (int j = 0; j < kRows; ++j) {
            const double phi = 2 * pi * (j + 0.5) / kRows;
            const double sine = std::sqrt(1 - z * z);
            const dvec3 wi(sine * std::cos(phi), sine * std::sin(phi), z);
            const auto value = reference::evaluateLobe(lobe, up, wo, wi, reference::Transport::Radiance);
            sum += value.f * (std::abs(z) * 4 * pi / (kRows * kRows));
        }
    }
    return sum;
}

} // namespace

TEST_CASE("in a room of radiance 1 a rough surface shows its albedo, whichever strategy finds the light") {
    // Sampled lights and rays that hit them are combined by MIS weights; a wrong weight would show
    const std::string_view integrators[] = {"whitted", "ppm", "path"};
    const std::vector<Renderer> renderers = renderersOf(integrators);
    FalseAlarms alarms(3 * renderers.size());
    for (const MaterialModel& model :
         {MaterialModel(Conductor{{0.2, 0.9, 1.1}, {3.9, 2.4, 2.1}, 0.5}), MaterialModel(Dielectric{1.5, 0.5}),
          MaterialModel(MetallicRoughness{{0.9, 0.6, 0.3}, 1, 0.8})}) {
        const double expected = albedoAt45(model).x;
        for (const Renderer& renderer : renderers) {
            Scene scene = glowingRoom(model);
            scene.render.passes = 32;
            INFO(renderer.name << ", material " << model.type);
            // The midpoint rule is accurate to 1e-4; pixels are 1e-4 rad wide
            CHECK(
                judge(alarms, renderer, scene, everywhere(expected), Independent::Pixels, {.bias = 2e-4, .sees = 0.1}));
        }
    }
}

TEST_CASE("a coated floor straight below a point light has the radiance of its base and its coat") {
    // Light and camera above the point: wo = wi = n. Base: c (1 - F0) 21/20 / pi, coat: F0 D / 4 with D = 1 / (pi
    // alpha^2); no masking. L = I / d^2 times their sum, I = 3 W/sr, d = 2 m.
    Scene scene = reference::test::onePixel({0, 1, 0}, {0, 0, 0}, "whitted");
    scene.camera.up = {0, 0, 1};
    scene.lights = {{{0, 2, 0}, dvec3(3)}};
    const dvec3 color(0.2, 0.5, 0.9);
    const std::size_t floor = reference::test::addMaterial(scene, MetallicRoughness{color, 0, 0.5});
    reference::test::addObject(scene, Plane{{0, 0, 0}, {0, 1, 0}}, floor);
    const double alpha = 0.25;
    const dvec3 f = color * (0.96 * 21.0 / 20 / pi) + 0.04 / (4 * pi * alpha * alpha);
    const dvec3 expected = f * 3.0 / 4.0;
    CHECK(glm::length(dvec3(onDevice(scene)) - expected) < 1e-4 * glm::length(expected));
}

TEST_CASE("polished gold reflects a light in its own colour at normal incidence") {
    // ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2) per channel
    Scene scene = reference::test::onePixel({0, 0, 2}, {0, 0, 0}, "whitted");
    const Conductor gold{{0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}};
    const std::size_t metal = reference::test::addMaterial(scene, gold);
    reference::test::addObject(scene, Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, metal);
    reference::test::addObject(scene, Quad{{-1, -1, 3}, {0, 2, 0}, {2, 0, 0}}, std::nullopt, dvec3(4));
    const dvec3 k2 = gold.k * gold.k;
    const dvec3 F = ((gold.eta - 1.0) * (gold.eta - 1.0) + k2) / ((gold.eta + 1.0) * (gold.eta + 1.0) + k2);
    CHECK(glm::length(dvec3(onDevice(scene)) - 4.0 * F) < 1e-5);
    CHECK(glm::length(F - dvec3(0.97, 0.80, 0.32)) < 0.01); // as documented
}

} // namespace hyalite::testing
