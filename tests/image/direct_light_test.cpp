// Direct light from area lights against closed-form form factors, with every integrator.
#include "image/known_answer.h"
#include "unit/reference/support.h"

#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

// From a distance, the camera looks along -normal at the central part, `width` times `height`, of a white rectangle;
// `up` is along the height.
Scene lookingAt(const dvec3& middle, const dvec3& normal, const dvec3& up, double width, double height,
                double distance) {
    Scene scene;
    scene.camera.position = middle + distance * normal;
    scene.camera.lookAt = middle;
    scene.camera.up = up;
    scene.camera.fov = 2 * std::atan(height / 2 / distance) * 180 / pi;
    scene.camera.resolution = {static_cast<std::uint32_t>(16 * width / height), 16};
    scene.render.maxDepth = 2;
    scene.render.photons = 1000;
    scene.render.photonMap.causticPhotons = 0;
    scene.materials = {{.name = "white", .model = Diffuse{dvec3(1)}}};
    return scene;
}

// From one unit square to another opposite of it, at the distance 1 (C-11 of J. Howell's catalogue of configuration
// factors, X = Y = 1).
double parallelSquares() {
    const double root2 = std::numbers::sqrt2;
    return 2 / pi * (std::log(std::sqrt(4.0 / 3)) + 2 * root2 * std::atan(1 / root2) - 2 * std::atan(1.0));
}

// From a rectangle 1 by W to one 1 by H, perpendicular along the edge of length 1 (C-14 there).
double perpendicular(double W, double H) {
    const double w2 = W * W;
    const double h2 = H * H;
    const double logarithm = std::log((1 + w2) * (1 + h2) / (1 + w2 + h2)) +
                             w2 * std::log(w2 * (1 + w2 + h2) / ((1 + w2) * (w2 + h2))) +
                             h2 * std::log(h2 * (1 + h2 + w2) / ((1 + h2) * (h2 + w2)));
    const double r = std::sqrt(h2 + w2);
    return (W * std::atan(1 / W) + H * std::atan(1 / H) - r * std::atan(1 / r) + logarithm / 4) / (pi * W);
}

} // namespace

TEST_CASE("a square lights the square opposite it, and part of the adjacent one, by their form factors") {
    // The mean radiance of a white rectangle is F times that of the light, with F the form factor from the rectangle to
    // the light. Of the adjacent rectangle the far half is used: its F is that of the whole minus the near half's: (A
    // F(1) - A/2 F(1/2)) / (A/2). Next to the common edge, samples of the light have unbounded variance.
    CHECK(std::abs(parallelSquares() - 0.19982) < 5e-6); // as the catalogue says
    CHECK(std::abs(perpendicular(1, 1) - 0.20004) < 5e-6);
    // Opposite: the camera sees the floor at y = 0 from y = 0.5, below the light at y = 1
    Scene opposite = lookingAt({0.5, 0, 0.5}, {0, 1, 0}, {0, 0, -1}, 1, 1, 0.5);
    reference::test::addObject(opposite, Quad{{-1, 0, 2}, {3, 0, 0}, {0, 0, -3}}, 0);
    reference::test::addObject(opposite, Quad{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, std::nullopt, dvec3(1)); // faces down
    Scene beside = lookingAt({0.75, 0, 0.5}, {0, 1, 0}, {0, 0, -1}, 0.5, 1, 0.5);
    reference::test::addObject(beside, Quad{{-1, 0, 2}, {3, 0, 0}, {0, 0, -3}}, 0);
    reference::test::addObject(beside, Quad{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, std::nullopt, dvec3(1)); // faces +x
    const double farHalf = 2 * perpendicular(1, 1) - perpendicular(0.5, 1);
    FalseAlarms alarms(2 * everyRenderer().size());
    for (auto& [name, scene, expected] :
         {std::tuple{"opposite", opposite, parallelSquares()}, {"beside", beside, farHalf}}) {
        for (const Renderer& renderer : everyRenderer()) {
            INFO(renderer.name << ", " << name);
            Scene picture = scene;
            picture.render.passes = 32;
            // Pixels also differ by the area that they see: the scatter is overestimated
            CHECK(judge(alarms, renderer, picture, everywhere(expected), Independent::Pixels,
                        {.bias = 1e-5, .sees = 0.2}));
        }
    }
}

TEST_CASE("half a sky lights a point of the floor with pi / 2") {
    Scene scene;
    scene.environment = Environment{.image = Image(2, 1)};
    scene.environment->image.at(1, 0) = glm::vec3(1);
    const Scene picture = reference::test::onePixel({3, 1, 0}, {0, 0, 0}, "whitted");
    scene.camera = picture.camera;
    scene.camera.resolution = {16, 16};
    scene.render = picture.render;
    scene.render.maxDepth = 2;
    scene.render.passes = 32;
    scene.render.photonMap.causticPhotons = 0;
    const std::size_t white = reference::test::addMaterial(scene, Diffuse{dvec3(1)});
    reference::test::addObject(scene, Quad{{-5, 0, 5}, {10, 0, 0}, {0, 0, -10}}, white);
    FalseAlarms alarms(everyRenderer().size());
    for (const Renderer& renderer : everyRenderer()) {
        INFO(renderer.name);
        CHECK(judge(alarms, renderer, scene, everywhere(0.5), Independent::Pixels, {.bias = 1e-4, .sees = 0.05}));
    }
}

} // namespace hyalite::testing
