// Scenes of several lights: cutting a light into parts changes nothing, nor does a light that is kept out, however
// strong; and a weak light is found beside it.
#include "image/known_answer.h"
#include "render/renderer.h"
#include "support/gpu_fixture.h"
#include "unit/reference/support.h"

#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr std::string_view kWithIndirectLight[] = {"ppm", "photonmap", "path"};

// The camera looks down at the white floor between x, z = 0 and 1, seen from below the lights at y = 1.
Scene overFloor() {
    Scene scene;
    scene.camera.position = {0.5, 0.5, 0.5};
    scene.camera.lookAt = {0.5, 0, 0.5};
    scene.camera.up = {0, 0, -1};
    scene.camera.fov = 90;
    scene.camera.resolution = {16, 16};
    scene.render.maxDepth = 2;
    scene.render.passes = 32;
    scene.render.photons = 1000;
    scene.render.photonMap.causticPhotons = 0;
    scene.materials = {{.name = "white", .model = Diffuse{dvec3(1)}}};
    reference::test::addObject(scene, Quad{{-1, 0, 2}, {3, 0, 0}, {0, 0, -3}}, 0);
    return scene;
}

// A unit square of radiance 1 at y = 1 that faces the floor, as `parts` times `parts` lights of its own.
void addSquare(Scene& scene, int parts) {
    const double edge = 1.0 / parts;
    for (int i = 0; i < parts * parts; ++i) {
        const dvec3 corner((i % parts) * edge, 1, static_cast<double>(i / parts) * edge);
        reference::test::addObject(scene, Quad{corner, {edge, 0, 0}, {0, 0, edge}}, std::nullopt, dvec3(1));
    }
}

// A sun and a sky, both thousands of times as strong, outside a black shell.
void addWorldOutside(Scene& scene) {
    scene.directionals = {{.direction = {0, -1, 0}, .irradiance = dvec3(2000)}};
    scene.environment = Environment{.image = Image(1, 1)};
    scene.environment->image.at(0, 0) = glm::vec3(1000);
    reference::test::addObject(scene, Sphere{{0, 0, 0}, 20}, std::nullopt);
}

// A diffuse ball of radius 1 and albedo 1/2 about the camera and a point light of pi W/sr: L = 1/2 (1 + … + 2^-62) = 1,
// see lit_sphere_test.cpp.
Scene ballWithLight() {
    Scene scene = reference::test::onePixel({0.2, 0.1, 0}, {1, 0.3, 0.2}, "ppm");
    scene.camera.resolution = {8, 8};
    scene.camera.fov = 60;
    scene.lights = {{{0, 0, 0}, dvec3(pi)}};
    scene.render.maxDepth = 64;
    scene.render.radius = 0.25;
    scene.render.photonMap.nearest = 512;
    scene.render.photonMap.gatherRays = 0;
    reference::test::addObject(scene, Sphere{{0, 0, 0}, 1}, reference::test::addMaterial(scene, Diffuse{dvec3(0.5)}));
    return scene;
}

} // namespace

TEST_CASE("a light in 81 parts lights the floor as a whole one does, and a sun that is kept out adds nothing") {
    // The form factor of opposite unit squares at the distance 1 is 0.19982 (C-11 of J. Howell's catalogue)
    const double root2 = std::numbers::sqrt2;
    const double expected =
        2 / pi * (std::log(std::sqrt(4.0 / 3)) + 2 * root2 * std::atan(1 / root2) - 2 * std::atan(1.0));
    Scene parts = overFloor();
    addSquare(parts, 9);
    Scene underSun = overFloor();
    addSquare(underSun, 1);
    addWorldOutside(underSun);
    FalseAlarms alarms(2 * everyRenderer().size());
    for (const auto& [name, scene] : {std::pair{"in parts", parts}, std::pair{"under a sun", underSun}}) {
        for (const Renderer& renderer : everyRenderer()) {
            INFO(renderer.name << ", " << name);
            CHECK(
                judge(alarms, renderer, scene, everywhere(expected), Independent::Pixels, {.bias = 1e-5, .sees = 0.2}));
        }
    }
}

TEST_CASE("a light in a closed ball is found under a sun a million times as strong, and beside 299 lights outside") {
    Scene underSun = ballWithLight();
    addWorldOutside(underSun);
    Scene amongMany = ballWithLight();
    reference::test::Random random;
    for (int i = 0; i < 299; ++i) {
        amongMany.lights.push_back({3.0 * glm::normalize(random.inCube(1)), dvec3(10)});
    }
    const std::vector<Renderer> renderers = renderersOf(kWithIndirectLight);
    FalseAlarms alarms(2 * renderers.size());
    for (auto& [name, scene] : {std::pair{"sun", underSun}, std::pair{"many", amongMany}}) {
        for (const Renderer& renderer : renderers) {
            INFO(renderer.name << ", " << name);
            Scene picture = scene;
            picture.render.passes = renderer.integrator == "path" ? 512 : renderer.integrator == "ppm" ? 48 : 8;
            picture.render.photons = renderer.integrator == "photonmap" ? 40000 : 8000; // half are the light's
            CHECK(judge(alarms, renderer, picture, everywhere(1), Independent::Renders, {.bias = 1e-5, .sees = 0.3}));
        }
    }
}

TEST_CASE("no target error is met while nothing has been found where light was sought") {
    // The sun is kept out, and the spot shines away from the floor that the camera sees: all of it stays black
    Scene scene = overFloor();
    addWorldOutside(scene);
    scene.spots = {{.position = {0.5, 0.6, 0.5}, .direction = {0, 1, 0}, .angle = 10}};
    scene.render.passes = 40;
    scene.render.targetError = 0.5;
    for (const std::string_view integrator : kWithIndirectLight) {
        INFO(integrator);
        scene.render.integrator = integrator;
        const render::RenderResult found = render::render(Gpu::shared().context(), Gpu::shared().compiler(), scene, {});
        CHECK(found.passes == 40);
        CHECK_FALSE(found.errorEstimate.error.has_value());
        CHECK(found.errorEstimate.darkPixels == 16 * 16);
    }
}

} // namespace hyalite::testing
