// Recursive ray tracing against closed forms: one pixel, one ray, one number.
#include "reference/integrators/whitted.h"

#include "unit/reference/support.h"

#include <cmath>
#include <numbers>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

using std::numbers::pi;

double radiance(const Scene& scene) {
    return whittedRadiance(prepareWorld(scene), 0, 0).x;
}

// A floor y = 0 of albedo 0.6 seen at the origin, lit by a point of 10 W/sr at (1, 2, 0).
Scene litFloor() {
    Scene scene = onePixel({0, 3, 4}, {0, 0, 0}, "whitted");
    const std::size_t floor = addMaterial(scene, Diffuse{dvec3(0.6)});
    addObject(scene, Quad{{-5, 0, -5}, {0, 0, 10}, {10, 0, 0}}, floor);
    scene.lights = {{.position = {1, 2, 0}, .intensity = dvec3(10)}};
    return scene;
}

// L = albedo / pi * I * cos / d^2 with d^2 = 5, cos = 2 / sqrt 5. The pixel's footprint of 1e-3 m moves L by less than
// 1e-3 relative; its mean moves in the second order.
const double kLitFloor = 0.6 / pi * 10 * 2 / (5 * std::sqrt(5.0));

// A light of radiance 7 seen straight through a pane of ior 1.5.
Scene pane(std::uint32_t maxDepth) {
    Scene scene = onePixel({0, 0, 5}, {0, 0, 0}, "whitted");
    scene.render.maxDepth = maxDepth;
    scene.render.minWeight = 0;
    const std::size_t glass = addMaterial(scene, Dielectric{1.5});
    addObject(scene, Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, glass);  // front towards the camera
    addObject(scene, Quad{{-1, -1, -1}, {0, 2, 0}, {2, 0, 0}}, glass); // front away from it
    addObject(scene, Quad{{-1, -1, -2}, {2, 0, 0}, {0, 2, 0}}, std::nullopt, dvec3(7));
    return scene;
}

constexpr double kF = 0.04; // ((1.5 - 1) / (1.5 + 1))^2

} // namespace

TEST_CASE("a point light over a floor gives albedo / pi I cos / d^2") {
    CHECK_THAT(radiance(litFloor()), WithinRel(kLitFloor, 1e-3));
}

TEST_CASE("all lights add up, each by its own shadow ray") {
    Scene scene = litFloor();
    scene.lights.push_back({.position = {-1, 2, 0}, .intensity = dvec3(20)}); // the mirror image, twice as strong
    CHECK_THAT(radiance(scene), WithinRel(3 * kLitFloor, 2e-3));
    addObject(scene, Sphere{{-0.5, 1, 0}, 0.1}, std::nullopt); // in the way of the second
    CHECK_THAT(radiance(scene), WithinRel(kLitFloor, 1e-3));
}

TEST_CASE("a mirror shows the light times its reflectance, and nothing at depth 0") {
    Scene scene = onePixel({0, 0, 5}, {0, 0, 0}, "whitted");
    const std::size_t mirror = addMaterial(scene, Mirror{dvec3(0.9)});
    addObject(scene, Quad{{-1, -1, 1}, {2, 0, -2}, {0, 2, 0}}, mirror);                // normal along (1, 0, 1)
    addObject(scene, Quad{{5, -1, -1}, {0, 0, 2}, {0, 2, 0}}, std::nullopt, dvec3(2)); // x = 5, facing -x
    CHECK_THAT(radiance(scene), WithinRel(0.9 * 2, 1e-14));
    scene.render.maxDepth = 0;
    CHECK(radiance(scene) == 0);
}

TEST_CASE("a pane transmits (1 - F)^2, and more with each pair of reflections inside") {
    // Entering scales radiance by 1 / n^2, leaving by n^2. Depth 2 allows both refractions; two more let light that was
    // reflected at the back and at the front through, a factor F^2; in the limit (1 - F)^2 / (1 - F^2).
    // Over the pixel F is constant to the square of its 1e-4 rad.
    const double through = 7 * (1 - kF) * (1 - kF);
    CHECK(radiance(pane(1)) == 0);
    CHECK_THAT(radiance(pane(2)), WithinRel(through, 1e-8));
    CHECK_THAT(radiance(pane(3)), WithinRel(through, 1e-8));
    CHECK_THAT(radiance(pane(4)), WithinRel(through * (1 + kF * kF), 1e-8));
    CHECK_THAT(radiance(pane(20)), WithinRel(7 * (1 - kF) / (1 + kF), 1e-8));
}

TEST_CASE("rays below the minimum weight are not followed") {
    // Reflections weigh 0.04 / 2.25 inside the glass: at 0.05 none is followed, only the straight path with 0.96 / 2.25
    // = 0.43 and 0.96^2 is.
    Scene scene = pane(20);
    scene.render.minWeight = 0.05;
    CHECK_THAT(radiance(scene), WithinRel(7 * (1 - kF) * (1 - kF), 1e-8));
    scene.render.minWeight = 0.43; // 0.96 / 2.25 = 0.4267: not even that
    CHECK(radiance(scene) == 0);
}

TEST_CASE("a light inside glass is seen from outside at (1 - F) / n^2 of its radiance") {
    Scene scene = pane(5);
    scene.objects.erase(scene.objects.begin() + 1); // no back face: the light is inside the glass
    CHECK_THAT(radiance(scene), WithinRel(7 * (1 - kF) / 2.25, 1e-8));
}

TEST_CASE("the picture's pixels are the means of their samples") {
    Scene scene = cornellBox();
    scene.render.integrator = "whitted";
    scene.render.passes = 3;
    scene.render.maxDepth = 4;
    const World world = prepareWorld(scene);
    const Image image = render(scene, renderWhitted).picture;
    REQUIRE(image.width == 16);
    REQUIRE(image.height == 16);
    for (std::uint32_t pixel = 0; pixel < 256; ++pixel) {
        dvec3 sum(0);
        for (std::uint32_t pass = 0; pass < 3; ++pass) {
            sum += whittedRadiance(world, pixel, pass);
        }
        CHECK(image.pixels[pixel] == glm::vec3(sum / 3.0));
    }
}
