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

// A diffuse sphere of radius 1 about the origin, a point light at its centre, the camera beside the light.
Scene litSphere(double albedo, double intensity) {
    Scene scene = reference::test::onePixel({0.2, 0.1, 0}, {1, 0.3, 0.2}, Integrator::Ppm);
    scene.camera.fov = 60;
    scene.camera.resolution = {16, 16};
    scene.lights = {{{0, 0, 0}, dvec3(intensity)}};
    const std::size_t diffuse = reference::test::addMaterial(scene, Diffuse{dvec3(albedo)});
    reference::test::addObject(scene, Sphere{{0, 0, 0}, 1}, diffuse);
    return scene;
}

} // namespace

TEST_CASE("a diffuse sphere with albedo one half and a light of pi W/sr at its centre has radiance 1 everywhere") {
    // Direct: E = I / r^2 = pi, L = albedo / pi * E = 1/2. The sphere sees itself evenly, so every further bounce
    // brings albedo times the one before: L = 1/2 (1 + 1/2 + 1/4 + …) = 1.
    Scene scene = litSphere(0.5, std::numbers::pi);
    scene.render.maxDepth = 64;
    scene.render.passes = 8;
    scene.render.photons = 50000;
    scene.render.radius = 0.1;
    const Image image = onDevice(scene);
    // Flux is conserved exactly on the sphere but for the disc's flatness: a cap of chord r has the area pi r^2 of the
    // disc. What remains is noise: about 50 000 stored photons a pass, 0.0025 of the sphere in a disc, 125 per
    // estimate and 8 passes: 3 % of the indirect half in one pixel, less in the mean of 256 of which some 30 are far
    // enough apart to be independent: 0.3 % of 1. Five standard deviations:
    CHECK(std::abs(meanOf(image).x - 1) < 0.015);
    // Single pixels: five times 1.6 %
    for (const vec3& pixel : image.pixels) {
        CHECK(std::abs(pixel.x - 1) < 0.08);
    }
}

TEST_CASE("cut after n segments the lit sphere has the first terms of its series only") {
    // Segments: camera + light = 2 for direct light, one more per bounce: maxDepth 3 leaves 1/2 + 1/4
    for (const auto& [maxDepth, expected] : {std::pair{2U, 0.5}, {3U, 0.75}, {4U, 0.875}}) {
        Scene scene = litSphere(0.5, std::numbers::pi);
        scene.render.maxDepth = maxDepth;
        scene.render.passes = 8;
        scene.render.photons = 50000;
        scene.render.radius = 0.1;
        CHECK(std::abs(meanOf(onDevice(scene)).x - expected) < 0.015);
    }
    // No segment is left for the light
    Scene scene = litSphere(0.5, std::numbers::pi);
    scene.render.maxDepth = 1;
    scene.render.passes = 1;
    CHECK(meanOf(onDevice(scene)).x == 0);
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

} // namespace hyalite::testing
