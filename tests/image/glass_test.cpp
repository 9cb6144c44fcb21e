// Glass with closed-form transmission: panes at any angle, and a ball that focuses a beam.
#include "image/known_answer.h"
#include "unit/reference/support.h"

#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

// Fresnel reflectance for unpolarised light at glass of index n, with the outside ray at `angle` to the normal.
double fresnel(double angle, double n) {
    const double out = std::cos(angle);
    const double in = std::cos(std::asin(std::sin(angle) / n));
    return (std::pow((out - n * in) / (out + n * in), 2) + std::pow((n * out - in) / (n * out + in), 2)) / 2;
}

} // namespace

TEST_CASE("a light reflected in a glass face has radiance F L, and at least kShareToLight of the paths see it") {
    // The camera is at 30 degrees to the normal, and a light of any shape is in the mirror direction; nothing is behind
    // the pane. A path that sees the light every second time must contribute 2 F L.
    const double angle = pi / 6;
    const double L = 7;
    const double expected = fresnel(angle, 1.5) * L;
    const dvec3 away(-std::sin(angle), 0, std::cos(angle));
    const dvec3 side(std::cos(angle), 0, std::sin(angle));
    const std::vector<Shape> lights{Quad{2.0 * away - 0.5 * side - dvec3(0, 0.5, 0), {0, 1, 0}, side},
                                    Disk{2.0 * away, {0, 0.7, 0}, 0.7 * side}, Sphere{2.0 * away, 0.7}};
    const std::string_view byChance[] = {"ppm", "path"};
    const std::vector<Renderer> renderers = renderersOf(byChance);
    FalseAlarms alarms(lights.size() * renderers.size());
    for (const Shape& light : lights) {
        Scene scene = reference::test::onePixel({3 * std::sin(angle), 0, 3 * std::cos(angle)}, {0, 0, 0}, "ppm");
        scene.camera.resolution = {32, 32};
        scene.render.maxDepth = 2;
        scene.render.passes = 1;
        const std::size_t glass = reference::test::addMaterial(scene, Dielectric{1.5});
        reference::test::addObject(scene, Quad{{-5, -5, 0}, {10, 0, 0}, {0, 10, 0}}, glass);
        reference::test::addObject(scene, light, std::nullopt, dvec3(L));
        for (const Renderer& renderer : renderers) {
            INFO(renderer.name << ", light " << light.index());
            CHECK(
                judge(alarms, renderer, scene, everywhere(expected), Independent::Pixels, {.bias = 2e-4, .sees = 0.3}));
            for (const double ratio : pixelRatios(renderBy(renderer, scene), everywhere(expected))) {
                CHECK((ratio == 0 || std::abs(ratio - 2) < 1e-3));
            }
        }
    }
}

namespace {

// Transmittance of both faces of a glass ball (n = 1.5, radius 1) for a ray at the distance h from its axis, and the
// distance from the axis at which it hits a floor at y = -1.5, the paraxial focus n R / (2 (n - 1)).
std::pair<double, double> throughBall(double h) {
    const double deviation = 2 * (std::asin(h) - std::asin(h / 1.5));
    const double F = fresnel(std::asin(h), 1.5); // at the exit from inside, the same by Stokes' relations
    return {(1 - F) * (1 - F), (h / std::sin(deviation) - 1.5) * std::tan(deviation)};
}

} // namespace

TEST_CASE("a glass ball brings the flux of a beam to its focus, in the picture") {
    // A beam of 1 W/m^2, 0.5 m in radius, along -y; from below the ball the camera looks at a white square of the
    // floor, centred on the focus, that receives the whole beam: mean radiance = flux / (pi area).
    Scene scene = reference::test::onePixel({0, -1.2, 0}, {0, -1.5, 0}, "ppm");
    const double half = 0.25;
    scene.camera.up = {0, 0, 1};
    scene.camera.fov = 2 * std::atan(half / 0.3) * 180 / pi;
    scene.camera.resolution = {32, 32};
    scene.directionals.push_back({.direction = {0, -1, 0},
                                  .irradiance = dvec3(1),
                                  .beam = DirectionalLight::Beam{.center = {0, 3, 0}, .radius = 0.5}});
    const std::size_t glass = reference::test::addMaterial(scene, Dielectric{1.5});
    const std::size_t white = reference::test::addMaterial(scene, Diffuse{dvec3(1)});
    reference::test::addObject(scene, Sphere{{0, 0, 0}, 1}, glass);
    reference::test::addObject(scene, Quad{{-9, -1.5, 9}, {18, 0, 0}, {0, 0, -18}}, white);
    scene.render.maxDepth = 4; // in, out, floor, eye: no internal reflections
    scene.render.photons = 4000;
    scene.render.passes = 4;
    scene.render.radius = 0.08;
    scene.render.photonMap.gatherRays = 0;
    scene.render.photonMap.causticPhotons = 500; // so few that all within reach count: the discs keep their size
    scene.render.photonMap.causticNearest = 512;
    scene.render.photonMap.causticRadius = 0.08;
    scene.render.photonMap.causticFilter = PhotonFilter::None;
    double flux = 0;
    constexpr int kRings = 20000;
    for (int i = 0; i < kRings; ++i) {
        const double h = 0.5 * (i + 0.5) / kRings;
        const auto [share, aside] = throughBall(h);
        REQUIRE(std::abs(aside) < half - 0.08 * 1.01); // the picture contains the discs about all landing points
        flux += 2 * pi * h * 0.5 / kRings * share;
    }
    const double expected = flux / (pi * 4 * half * half);
    const std::string_view withCaustics[] = {"ppm", "photonmap"};
    const std::vector<Renderer> renderers = renderersOf(withCaustics);
    FalseAlarms alarms(renderers.size());
    for (const Renderer& renderer : renderers) {
        INFO(renderer.name);
        CHECK(judge(alarms, renderer, scene, everywhere(expected), Independent::Renders, {.bias = 1e-4, .sees = 0.2}));
    }
}

} // namespace hyalite::testing
