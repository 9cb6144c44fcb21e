// Scenes with analytically known radiance, rendered on the device.
#include "kernel/kernel_support.h"
#include "render/integrators/ppm/ppm.h"
#include "render/renderer.h"

namespace hyalite::testing {

namespace {

Image onDevice(const Scene& scene) {
    return render::render(Gpu::shared().context(), Gpu::shared().compiler(), scene, {}).image.picture;
}

dvec3 meanOf(const Image& image) {
    dvec3 sum(0);
    for (const vec3& pixel : image.pixels) {
        sum += dvec3(pixel);
    }
    return sum / static_cast<double>(image.pixels.size());
}

} // namespace

TEST_CASE("whitted lights a floor by the inverse square of the distance and the cosine") {
    // Light 2 m above the plane y = 0, I = 3 W/sr; at a point 1.5 m aside d^2 = 6.25, cos = 2 / 2.5 = 0.8:
    // L = albedo / pi * I cos / d^2
    Scene scene = reference::test::onePixel({1.5, 1, 0.0001}, {1.5, 0, 0}, "whitted");
    scene.lights = {{{0, 2, 0}, dvec3(3)}};
    const std::size_t floor = reference::test::addMaterial(scene, Diffuse{{0.2, 0.5, 0.9}});
    reference::test::addObject(scene, Quad{{-5, 0, 5}, {10, 0, 0}, {0, 0, -10}}, floor);
    const dvec3 expected = dvec3(0.2, 0.5, 0.9) / std::numbers::pi * 3.0 * 0.8 / 6.25;
    CHECK(glm::length(meanOf(onDevice(scene)) - expected) < 1e-4 * glm::length(expected));
    // A ball between light and floor blocks all light
    reference::test::addObject(scene, Sphere{{0.75, 1, 0}, 0.1}, floor);
    CHECK(meanOf(onDevice(scene)) == dvec3(0));
}

TEST_CASE("a mirror at depth 0 is black and from depth 1 on shows the light times its reflectance") {
    Scene scene = reference::test::onePixel({0, 0, 2}, {0, 0, 0}, "whitted");
    const std::size_t mirror = reference::test::addMaterial(scene, Mirror{{0.9, 0.5, 0.1}});
    reference::test::addObject(scene, Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, mirror);
    // Behind the camera, facing the mirror
    reference::test::addObject(scene, Quad{{-1, -1, 3}, {0, 2, 0}, {2, 0, 0}}, std::nullopt, dvec3(4));
    scene.render.maxDepth = 0;
    CHECK(meanOf(onDevice(scene)) == dvec3(0));
    scene.render.maxDepth = 1;
    CHECK(glm::length(meanOf(onDevice(scene)) - dvec3(3.6, 2, 0.4)) < 1e-5);
}

TEST_CASE("the search radius shrinks as Knaus and Zwicker prescribe") {
    // alpha = 2/3: r^2_1 = r^2_0 (1 + 2/3)/2, r^2_2 = r^2_1 (2 + 2/3)/3
    const double first = 5.0 / 6;
    const double second = first * 8.0 / 9;
    CHECK(render::searchRadius(2, 2.0 / 3, 0) == 2);
    CHECK(std::abs(render::searchRadius(2, 2.0 / 3, 1) - 2 * std::sqrt(first)) < 1e-15);
    CHECK(std::abs(render::searchRadius(2, 2.0 / 3, 2) - 2 * std::sqrt(second)) < 1e-15);
    // Asymptotically r^2_n ~ n^(alpha - 1): a thousandfold n shrinks r^2 by 10^-1
    const double ratio = render::searchRadius(1, 2.0 / 3, 1000000) / render::searchRadius(1, 2.0 / 3, 1000);
    CHECK(std::abs(ratio * ratio - 0.1) < 1e-4);
}

// One pixel of a white floor at the origin, seen from above, under the scene's lights.
double radianceOfFloor(Scene scene) {
    Scene picture = reference::test::onePixel({3, 1, 0}, {0, 0, 0}, "whitted");
    scene.camera = picture.camera;
    scene.render = picture.render;
    scene.render.passes = 256;
    const std::size_t white = reference::test::addMaterial(scene, Diffuse{dvec3(1)});
    reference::test::addObject(scene, Quad{{-5, 0, 5}, {10, 0, 0}, {0, 0, -10}}, white);
    return meanOf(onDevice(scene)).x;
}

TEST_CASE("a floor has the radiance that spots and parallel light give it") {
    const double pi = std::numbers::pi;
    // The full intensity of a spot at (3, 4, 0) aimed at the origin: I cos / (pi d^2) = 10 * 0.8 / 25 / pi
    Scene spot;
    spot.spots = {{.position = {3, 4, 0}, .direction = {-0.6, -0.8, 0}, .intensity = dvec3(10), .angle = 5}};
    CHECK(std::abs(radianceOfFloor(spot) - 0.32 / pi) < 1e-5);
    // Aimed 6 degrees past it
    const double angle = std::atan2(3.0, 4.0) + 6 * pi / 180;
    spot.spots[0].direction = {-std::sin(angle), -std::cos(angle), 0};
    CHECK(radianceOfFloor(spot) == 0);
    // E cos / pi
    Scene parallel;
    parallel.directionals = {{.direction = {0, -0.6, 0.8}, .irradiance = dvec3(10)}};
    CHECK(std::abs(radianceOfFloor(parallel) - 6 / pi) < 1e-5);
    // A beam whose rim is 1 mm beyond the floor's point, or 1 mm short of it
    parallel.directionals[0].beam = DirectionalLight::Beam{{0.499, 0.6, -0.8}, 0.5};
    CHECK(std::abs(radianceOfFloor(parallel) - 6 / pi) < 1e-5);
    parallel.directionals[0].beam = DirectionalLight::Beam{{0.501, 0.6, -0.8}, 0.5};
    CHECK(radianceOfFloor(parallel) == 0);
}

} // namespace hyalite::testing
