// Scenes whose radiance is known on paper, rendered on the device.
#include "kernel/kernel_support.h"
#include "render/ppm.h"
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

TEST_CASE("a pane of absorbing glass transmits (1 - F)^2 a / (1 - F^2 a^2)") {
    // a = e^(-sigma d) is what one passage leaves; each pair of reflections within the pane takes F^2 and two passages
    // more. F = ((n - 1) / (n + 1))^2 at normal incidence; a light of radiance 1 stands behind the pane.
    const double d = 0.4;
    const double n = 1.5;
    const dvec3 sigma(0, 1.5, 6);
    Scene scene = reference::test::onePixel({0, 0, 3}, {0, 0, 0}, Integrator::Whitted);
    scene.render.maxDepth = 30;
    scene.render.minWeight = 0;
    const std::size_t glass = reference::test::addMaterial(scene, Dielectric{n, 0, sigma});
    reference::test::addObject(scene, Quad{{-1, -1, d / 2}, {2, 0, 0}, {0, 2, 0}}, glass);
    reference::test::addObject(scene, Quad{{-1, -1, -d / 2}, {0, 2, 0}, {2, 0, 0}}, glass);
    reference::test::addObject(scene, Quad{{-1, -1, -3}, {2, 0, 0}, {0, 2, 0}}, std::nullopt, dvec3(1));
    const vec3 L = onDevice(scene).at(0, 0);
    const double F = std::pow((n - 1) / (n + 1), 2);
    for (int channel = 0; channel < 3; ++channel) {
        const double a = std::exp(-sigma[channel] * d);
        const double expected = (1 - F) * (1 - F) * a / (1 - F * F * a * a);
        // The thickness is the difference of two positions right to 1e-7: 6/m makes 1e-6 of it; and roundings
        CHECK(std::abs(double{L[channel]} - expected) < 3e-6 * expected);
    }
}

TEST_CASE("whitted lights a floor by the inverse square of the distance and the cosine") {
    // Light 2 m above the plane y = 0, I = 3 W/sr; at a point 1.5 m aside d^2 = 6.25, cos = 2 / 2.5 = 0.8:
    // L = albedo / pi * I cos / d^2
    Scene scene = reference::test::onePixel({1.5, 1, 0.0001}, {1.5, 0, 0}, Integrator::Whitted);
    scene.lights = {{{0, 2, 0}, dvec3(3)}};
    const std::size_t floor = reference::test::addMaterial(scene, Diffuse{{0.2, 0.5, 0.9}});
    reference::test::addObject(scene, Quad{{-5, 0, 5}, {10, 0, 0}, {0, 0, -10}}, floor);
    const dvec3 expected = dvec3(0.2, 0.5, 0.9) / std::numbers::pi * 3.0 * 0.8 / 6.25;
    CHECK(glm::length(meanOf(onDevice(scene)) - expected) < 1e-4 * glm::length(expected));
    // A ball between light and floor leaves no light
    reference::test::addObject(scene, Sphere{{0.75, 1, 0}, 0.1}, floor);
    CHECK(meanOf(onDevice(scene)) == dvec3(0));
}

TEST_CASE("a mirror at depth 0 is black and from depth 1 on shows the lamp times its reflectance") {
    Scene scene = reference::test::onePixel({0, 0, 2}, {0, 0, 0}, Integrator::Whitted);
    const std::size_t mirror = reference::test::addMaterial(scene, Mirror{{0.9, 0.5, 0.1}});
    reference::test::addObject(scene, Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, mirror);
    // Behind the camera, facing the mirror
    reference::test::addObject(scene, Quad{{-1, -1, 3}, {0, 2, 0}, {2, 0, 0}}, std::nullopt, dvec3(4));
    scene.render.maxDepth = 0;
    CHECK(meanOf(onDevice(scene)) == dvec3(0));
    scene.render.maxDepth = 1;
    CHECK(glm::length(meanOf(onDevice(scene)) - dvec3(3.6, 2, 0.4)) < 1e-5);
}

TEST_CASE("a pane of glass lets (1-R)/(1+R) of the light through at normal incidence") {
    // R = ((n-1)/(n+1))^2 = 0.04 for n = 1.5. Both faces and all reflections between them:
    // T = (1-R)^2 (1 + R^2 + R^4 + …) = (1-R)^2/(1-R^2) = (1-R)/(1+R) = 0.923077
    Scene scene = reference::test::onePixel({0, 0, 2}, {0, 0, 0}, Integrator::Whitted);
    const std::size_t glass = reference::test::addMaterial(scene, Dielectric{1.5});
    reference::test::addObject(scene, Quad{{-1, -1, 0.1}, {2, 0, 0}, {0, 2, 0}}, glass);  // faces +z
    reference::test::addObject(scene, Quad{{-1, -1, -0.1}, {0, 2, 0}, {2, 0, 0}}, glass); // faces -z
    reference::test::addObject(scene, Quad{{-1, -1, -1}, {2, 0, 0}, {0, 2, 0}}, std::nullopt, dvec3(1));
    scene.render.maxDepth = 20;
    scene.render.minWeight = 0;
    CHECK(std::abs(meanOf(onDevice(scene)).x - 0.96 / 1.04) < 1e-5);
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

// One pixel that looks at the middle of a white floor, lit by one shape two metres above it.
double radianceBelow(const Shape& light, const dvec3& radiance) {
    Scene scene = reference::test::onePixel({3, 1, 0}, {0, 0, 0}, Integrator::Whitted);
    scene.render.passes = 512;
    const std::size_t white = reference::test::addMaterial(scene, Diffuse{dvec3(1)});
    reference::test::addObject(scene, Plane{{0, 0, 0}, {0, 1, 0}}, white);
    reference::test::addObject(scene, light, std::nullopt, radiance);
    return meanOf(onDevice(scene)).x;
}

TEST_CASE("a disk lights the point below its centre as its formula says") {
    // E = pi L r^2 / (r^2 + h^2) with r = 1, h = 2: pi L / 5; the floor is white: radiance E / pi = L / 5.
    // 512 stratified samples of a function that varies by a factor of 1.6: a few 1e-4
    CHECK(std::abs(radianceBelow(Disk{{0, 2, 0}, {0, 0, 1}, {-1, 0, 0}}, dvec3(5)) - 1) < 2e-3);
}

TEST_CASE("a sphere lights the point below it like its radiance over the square of the distance to its centre") {
    // E = pi L (r / d)^2 with r = 0.5, d = 2: pi L / 16. Samples differ more: half of the half that faces is behind its
    // own horizon
    CHECK(std::abs(radianceBelow(Sphere{{0, 2, 0}, 0.5}, dvec3(16)) - 1) < 1e-2);
}

// One pixel of a white floor at the origin, seen from above, under the scene's lights.
double radianceOfFloor(Scene scene) {
    Scene picture = reference::test::onePixel({3, 1, 0}, {0, 0, 0}, Integrator::Whitted);
    scene.camera = picture.camera;
    scene.render = picture.render;
    scene.render.passes = 256;
    const std::size_t white = reference::test::addMaterial(scene, Diffuse{dvec3(1)});
    reference::test::addObject(scene, Quad{{-5, 0, 5}, {10, 0, 0}, {0, 0, -10}}, white);
    return meanOf(onDevice(scene)).x;
}

TEST_CASE("a floor has the radiance that spots, parallel light and the sky give it") {
    const double pi = std::numbers::pi;
    // All the light of a spot at (3, 4, 0) aimed at the origin: I cos / (pi d^2) = 10 * 0.8 / 25 / pi
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
    // A beam whose rim is 1 mm this side of the floor's point, or the other
    parallel.directionals[0].beam = DirectionalLight::Beam{{0.499, 0.6, -0.8}, 0.5};
    CHECK(std::abs(radianceOfFloor(parallel) - 6 / pi) < 1e-5);
    parallel.directionals[0].beam = DirectionalLight::Beam{{0.501, 0.6, -0.8}, 0.5};
    CHECK(radianceOfFloor(parallel) == 0);
    // pi L / pi. A sample is 4 L cos or, from below, nothing: it deviates by 1.3 L, but the 256 are well spread
    Scene sky;
    sky.environment = Environment{.image = Image(1, 1), .scale = 2};
    sky.environment->image.at(0, 0) = vec3(1);
    CHECK(std::abs(radianceOfFloor(sky) - 2) < 0.02);
    // One half of the sky, x > 0: half the light
    sky.environment->image = Image(2, 1);
    sky.environment->image.at(1, 0) = vec3(1);
    CHECK(std::abs(radianceOfFloor(sky) - 1) < 0.02);
}

TEST_CASE("a square mesh lights a floor as the square does") {
    // The square of half width 1 at height 2, parallel to the floor and facing it: four times the form factor of a
    // corner, L 4 / (2 pi) 2 s atan(s), s = X / sqrt(1 + X^2) with X = 1/2
    const double s = 0.5 / std::sqrt(1.25);
    const double expected = 4 / (2 * std::numbers::pi) * 2 * s * std::atan(s);
    Scene scene;
    scene.meshes = {{.file = {},
                     .positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                     .normals = {},
                     .triangles = {{0, 1, 2}, {0, 2, 3}},
                     .uvs = {}}};
    const glm::dmat4 place(2, 0, 0, 0, 0, 0, 2, 0, 0, -1, 0, 0, -1, 2, -1, 1); // x to 2 x, y to 2 z, front down
    reference::test::addObject(scene, MeshInstance{0, place}, std::nullopt, dvec3(3));
    // Samples differ by a factor of two at most: 256 of them, independent, are right to 1.3 %
    CHECK(std::abs(radianceOfFloor(scene) - 3 * expected) < 0.02 * 3 * expected);
}

} // namespace hyalite::testing
