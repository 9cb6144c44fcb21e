// The inside of a diffuse sphere, which illuminates itself uniformly: light emitted or reflected by its walls arrives
// equally everywhere, wherever it started. So its radiance is an analytic series, wherever the light is, and also with
// a mirror inside.
#include "image/known_answer.h"
#include "unit/reference/support.h"

#include <algorithm>
#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr std::string_view kWithIndirectLight[] = {"ppm", "photonmap", "path"};
constexpr std::string_view kWithCaustics[] = {"ppm", "photonmap"};

// The camera at `from` looks at an area about `target`; a point light of pi W/sr.
Scene cameraInside(const dvec3& from, const dvec3& target, const dvec3& light) {
    Scene scene = reference::test::onePixel(from, target, "ppm");
    scene.camera.resolution = {8, 8};
    scene.camera.fov = 60;
    scene.lights = {{light, dvec3(pi)}};
    scene.render.passes = 8;
    scene.render.photons = 4000;
    scene.render.radius = 0.25; // a cap of chord r has the area of the disc, pi r^2: flux is conserved on the sphere
    scene.render.photonMap.nearest = 512;
    scene.render.photonMap.causticNearest = 512;
    scene.render.photonMap.gatherRays = 0;
    return scene;
}

// Sample counts that make the integrators equally precise: paths vary by their roulette, and photonmap has one map for
// all passes.
void adjust(RenderSettings& render, const Renderer& renderer) {
    const bool isPhotonMap = renderer.integrator == "photonmap";
    render.passes = renderer.integrator == "path" ? 256 : isPhotonMap ? 2 : 8;
    render.photons = isPhotonMap ? 16000 : 4000;
}

// Point of the unit sphere about the origin seen at picture coordinates x and y in [-1, 1], with y up.
dvec3 pointOnSphere(const Camera& camera, double x, double y) {
    const dvec3 forward = glm::normalize(camera.lookAt - camera.position);
    const dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const dvec3 up = glm::cross(right, forward);
    const double half = std::tan(glm::radians(camera.fov) / 2);
    const dvec3 d = glm::normalize(forward + half * (x * right + y * up));
    const double b = glm::dot(camera.position, d); // |position + t d| = 1
    return camera.position + (-b + std::sqrt(b * b + 1 - glm::dot(camera.position, camera.position))) * d;
}

// Mean over 8 x 8 points in each of 8 x 8 pixels.
ExpectedPixel meanOver(const Camera& camera, const std::function<double(const dvec3&)>& radiance) {
    return [=](int px, int py) {
        double sum = 0;
        for (int i = 0; i < 64; ++i) {
            const double x = (px + (i % 8 + 0.5) / 8) / 4 - 1;
            const int row = i / 8; // row 0 on top
            const double y = 1 - (py + (row + 0.5) / 8) / 4;
            sum += radiance(pointOnSphere(camera, x, y));
        }
        return sum / 64;
    };
}

} // namespace

TEST_CASE("a diffuse sphere around a light of pi W/sr has radiance a / (1 - a), or its truncated series") {
    // From the centre E = I / r^2 = pi, L = a E / pi = a. The wall illuminates itself uniformly, so each further bounce
    // is a times the previous one: n segments give the terms a + a^2 + … up to a^(n - 1)
    const std::vector<Renderer> renderers = renderersOf(kWithIndirectLight);
    const std::vector<std::pair<double, std::uint32_t>> cases{{0.8, 64}, {0.5, 5}};
    FalseAlarms alarms(renderers.size() * cases.size());
    for (const auto& [albedo, depth] : cases) {
        Scene scene = cameraInside({0.2, 0.1, 0}, {1, 0.3, 0.2}, {0, 0, 0});
        const std::size_t wall = reference::test::addMaterial(scene, Diffuse{dvec3(albedo)});
        reference::test::addObject(scene, Sphere{{0, 0, 0}, 1}, wall);
        scene.render.maxDepth = depth;
        const double expected = albedo * (1 - std::pow(albedo, depth - 1.0)) / (1 - albedo);
        for (const Renderer& renderer : renderers) {
            adjust(scene.render, renderer);
            INFO(renderer.name << ", albedo " << albedo << ", depth " << depth);
            CHECK(judge(alarms, renderer, scene, everywhere(expected), Independent::Renders,
                        {.bias = 1e-5, .sees = 0.2}));
        }
    }
}

TEST_CASE("a path of one segment is too short for light that is not directly visible") {
    Scene scene = cameraInside({0.2, 0.1, 0}, {1, 0.3, 0.2}, {0, 0, 0});
    scene.render.maxDepth = 1;
    scene.render.passes = 1;
    reference::test::addObject(scene, Sphere{}, reference::test::addMaterial(scene, Diffuse{}));
    for (const Renderer& renderer : renderersOf(kWithIndirectLight)) {
        INFO(renderer.name);
        const Image image = renderBy(renderer, scene);
        CHECK(std::ranges::all_of(image.pixels, [](const glm::vec3& pixel) { return pixel == glm::vec3(0); }));
    }
}

TEST_CASE("wherever the light in a diffuse sphere stands, its indirect light is the same") {
    // E(x) = I cos / d^2; its mean over the sphere is 4 pi I / (4 pi) = I. Light reflected by the walls arrives
    // uniformly, with a mean radiosity of a I / (1 - a), so that L(x) = a / pi (E(x) + a I / (1 - a)): a = 1/2, I = pi:
    // E / (2 pi) + 1/2
    const dvec3 light(-0.3, 0.4, 0.5);
    Scene scene = cameraInside({0.2, 0.1, 0}, {1, 0.3, 0.2}, light);
    const std::size_t wall = reference::test::addMaterial(scene, Diffuse{dvec3(0.5)});
    reference::test::addObject(scene, Sphere{{0, 0, 0}, 1}, wall);
    scene.render.maxDepth = 64;
    const ExpectedPixel expected = meanOver(scene.camera, [&](const dvec3& x) {
        const dvec3 way = x - light;
        return 0.5 * glm::dot(way, x) / std::pow(glm::length(way), 3) + 0.5; // cos = way . x / d
    });
    const std::vector<Renderer> renderers = renderersOf(kWithIndirectLight);
    FalseAlarms alarms(renderers.size());
    for (const Renderer& renderer : renderers) {
        adjust(scene.render, renderer);
        INFO(renderer.name);
        // The mean over 64 points of a pixel 0.1 wide: off by 1e-2 / 64 times the curvature of E, which is of order 1
        CHECK(judge(alarms, renderer, scene, expected, Independent::Renders, {.bias = 2e-4, .sees = 0.2}));
    }
}

TEST_CASE("a mirror as half of the sphere lights the other half like a second light") {
    // Light from the centre returns to it, so each point of the diffuse half receives (1 + rho) I. The diffuse half of
    // the wall that it sees has the radiosity a I from the light. Three segments allow for both and no more: L = a / pi
    // ((1 + rho) I + a I / 2), with a = 0.6, rho = 0.7, I = pi: 0.6 (1.7 + 0.3) = 1.2
    Scene scene = cameraInside({0.1, 0, -0.2}, {0.05, 0.1, 1}, {0, 0, 0});
    scene.camera.fov = 30;
    scene.render.maxDepth = 3;
    scene.render.photonMap.causticPhotons = 16000;
    scene.render.photonMap.causticRadius = 0.25;
    scene.render.photonMap.causticFilter = PhotonFilter::None;
    const QuadricForm form{.a = 1, .e = 1, .h = 1, .j = -1};
    const std::size_t wall = reference::test::addMaterial(scene, Diffuse{dvec3(0.6)});
    const std::size_t mirror = reference::test::addMaterial(scene, Mirror{dvec3(0.7)});
    reference::test::addObject(scene, Quadric{.form = form, .clip = {{-2, -2, 0}, {2, 2, 2}}, .capped = false}, wall);
    reference::test::addObject(scene, Quadric{.form = form, .clip = {{-2, -2, -2}, {2, 2, 0}}, .capped = false},
                               mirror);
    const std::vector<Renderer> renderers = renderersOf(kWithCaustics);
    FalseAlarms alarms(renderers.size());
    for (const Renderer& renderer : renderers) {
        INFO(renderer.name);
        // In floats a photon returning from the mirror lands within 1e-6 of its antipode
        CHECK(judge(alarms, renderer, scene, everywhere(1.2), Independent::Renders, {.bias = 1e-5, .sees = 0.2}));
    }
}

} // namespace hyalite::testing
