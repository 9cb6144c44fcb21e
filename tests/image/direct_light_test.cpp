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

// Irradiance at the origin, on a surface facing +y, from a polygon of radiance 1 above it with corners
// counter-clockwise as seen from its front (Lambert): half the sum over its edges of the angle that each subtends times
// the cosine between the surface's normal and that of the plane through edge and origin.
double lambertsPolygon(const std::vector<dvec3>& corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec3 a = glm::normalize(corners[i]);
        const dvec3 b = glm::normalize(corners[(i + 1) % corners.size()]);
        sum += std::acos(glm::dot(a, b)) * glm::normalize(glm::cross(b, a)).y;
    }
    return sum / 2;
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

TEST_CASE("lights of every shape light a point of the floor according to their formulas") {
    // The floor is white: radiance E / pi
    struct NamedLight {
        std::string name;
        Scene scene;
        double irradiance;
    };
    const auto with = [](const Shape& shape) {
        Scene scene;
        reference::test::addObject(scene, shape, std::nullopt, dvec3(1));
        return scene;
    };
    const Quad tilted{{-0.5, 1, 1}, {0.2, -0.3, -2}, {1.5, 0.4, 0}};
    const Quad square{{-1, 2, -1}, {2, 0, 0}, {0, 0, 2}};
    Scene mesh = with(MeshInstance{0, glm::dmat4(2, 0, 0, 0, 0, 0, 2, 0, 0, -1, 0, 0, -1, 2, -1, 1)});
    mesh.meshes = {{.file = {},
                    .positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, // x to 2 x, y to 2 z, front down
                    .normals = {},
                    .triangles = {{0, 1, 2}, {0, 2, 3}},
                    .uvs = {}}};
    Scene halfSky;
    halfSky.environment = Environment{.image = Image(2, 1)};
    halfSky.environment->image.at(1, 0) = glm::vec3(1);
    const auto polygon = [](const Quad& q) {
        return lambertsPolygon({q.corner, q.corner + q.edge0, q.corner + q.edge0 + q.edge1, q.corner + q.edge1});
    };
    const std::vector<NamedLight> lights{
        {"quad", with(tilted), polygon(tilted)},
        {"mesh", mesh, polygon(square)},
        {"disk", with(Disk{{0, 2, 0}, {0, 0, 1}, {-1, 0, 0}}), pi / 5},          // pi r^2 / (r^2 + h^2), r = 1, h = 2
        {"sphere", with(Sphere{{2, 2, 0}, 0.5}), pi / 32 / std::numbers::sqrt2}, // pi (r / d)^2 cos
        {"half a sky", halfSky, pi / 2},
    };
    // Four times the form factor of a square above its corner, 1 / (2 pi) 2 s atan s, s = X / sqrt(1 + X^2), X = 1/2
    const double s = 0.5 / std::sqrt(1.25);
    CHECK(std::abs(polygon(square) - 4 * s * std::atan(s)) < 1e-12);
    FalseAlarms alarms(lights.size() * everyRenderer().size());
    for (const NamedLight& light : lights) {
        Scene scene = light.scene;
        const Scene picture = reference::test::onePixel({3, 1, 0}, {0, 0, 0}, "whitted");
        scene.camera = picture.camera;
        scene.camera.resolution = {16, 16};
        scene.render = picture.render;
        scene.render.maxDepth = 2;
        scene.render.passes = 32;
        scene.render.photonMap.causticPhotons = 0;
        const std::size_t white = reference::test::addMaterial(scene, Diffuse{dvec3(1)});
        reference::test::addObject(scene, Quad{{-5, 0, 5}, {10, 0, 0}, {0, 0, -10}}, white);
        for (const Renderer& renderer : everyRenderer()) {
            INFO(renderer.name << ", " << light.name);
            CHECK(judge(alarms, renderer, scene, everywhere(light.irradiance / pi), Independent::Pixels,
                        {.bias = 1e-4, .sees = 0.05})); // pixels 1e-4 rad wide
        }
    }
}

} // namespace hyalite::testing
