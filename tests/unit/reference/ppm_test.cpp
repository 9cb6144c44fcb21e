// Progressive photon mapping against closed forms, and the guarantees of the pass loop.
#include "reference/integrators/ppm.h"

#include "unit/reference/support.h"

#include <cmath>
#include <numbers>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

using std::numbers::pi;

} // namespace

TEST_CASE("the squared radius follows the product of (k + alpha) / (k + 1)") {
    // After n steps r^2 / r0^2 = prod_{k=1}^{n} (k + a) / (k + 1) = Gamma(n + 1 + a) / (Gamma(1 + a) Gamma(n + 2)).
    const double alpha = 2.0 / 3;
    double radius2 = 4;
    for (std::uint32_t pass = 0; pass < 100; ++pass) {
        radius2 = nextRadius2(radius2, pass, alpha);
    }
    const double expected = 4 * std::tgamma(101 + alpha) / std::tgamma(1 + alpha) / std::tgamma(102);
    CHECK_THAT(radius2, WithinRel(expected, 1e-12));
    CHECK_THAT(nextRadius2(1, 0, alpha), WithinRel((1 + alpha) / 2, 1e-15));
}

TEST_CASE("a point light over an open floor gives albedo / pi I cos / d^2 by the shadow ray alone") {
    // d^2 = 5, cos = 2 / sqrt 5; light that leaves the floor never comes back, so no photon is stored.
    Scene scene = onePixel({0, 3, 4}, {0, 0, 0}, "ppm");
    const std::size_t floor = addMaterial(scene, Diffuse{dvec3(0.6)});
    addObject(scene, Quad{{-5, 0, -5}, {0, 0, 10}, {10, 0, 0}}, floor);
    scene.lights = {{.position = {1, 2, 0}, .intensity = dvec3(10)}};
    scene.render.photons = 500;
    const World world = prepareWorld(scene);
    const ProgressiveMaps maps = traceProgressive(world, {.global = 0.1}, 0);
    CHECK(maps.global.photons.photons().empty());
    CHECK_FALSE(maps.caustic);
    const double expected = 0.6 / pi * 10 * 2 / (5 * std::sqrt(5.0));
    CHECK_THAT(ppmRadiance(world, maps, 0, 0).x, WithinRel(expected, 1e-3)); // the footprint, see whitted
    // One segment sees the floor but has none left for the light.
    scene.render.maxDepth = 1;
    CHECK(ppmRadiance(prepareWorld(scene), maps, 0, 0).x == 0);
}

TEST_CASE("a hollow sphere of albedo 1/2 glows with twice its direct light") {
    // Unit sphere, point light I at the centre: every point of the wall gets E = I, so direct L = albedo / pi I. Light
    // diffusely reflected inside a sphere spreads evenly over it, each bounce halving it: L = direct (1 + 1/2 + ...),
    // here up to depth 11 of the photons: S = 1 - 2^-10. Estimator: the part of the sphere within distance r of a point
    // is a cap of area pi r^2 exactly, so the disc estimate has no other bias than this: photons that came from between
    // x and themselves, as seen along the normal, come from below x's horizon and are dropped. A photon at height h of
    // the cap (uniform in [0, r^2 / 2]) comes from a point spread evenly over the sphere, of which the share h / 2 lies
    // in that cap: on average r^2 / 8. The cap also stays within r / 4 of the tangent plane: its height r^2 / 2 <= r /
    // 4 for r <= 1/2.
    Scene scene;
    const std::size_t wall = addMaterial(scene, Diffuse{dvec3(0.5)});
    addObject(scene, Sphere{}, wall);
    scene.lights = {{.position = {0, 0, 0}, .intensity = dvec3(3)}};
    scene.camera = {.position = {0, 0, 0}, .lookAt = {1, 0, 0}, .up = {0, 1, 0}, .fov = 60, .resolution = {4, 4}};
    scene.render.integrator = "ppm";
    scene.render.maxDepth = 12;
    scene.render.passes = 24;
    scene.render.photons = 20000;
    scene.render.radius = 0.45;
    scene.render.alpha = 0.9;

    // Mean squared radius and variance of the mean over the passes: a pass finds N = photons * S * r^2 / 4 of them in a
    // cap, with relative variance 1 / N, and 2 % more because one path may land there twice (cap share 5 %, 0.4 further
    // landings of a path counted at its first); 5 standard errors of one pixel bound those of the picture's mean.
    const double S = 1 - std::pow(0.5, 10);
    double radius2 = 0.45 * 0.45;
    double meanRadius2 = 0;
    double variance = 0;
    for (std::uint32_t pass = 0; pass < scene.render.passes; ++pass) {
        meanRadius2 += radius2 / scene.render.passes;
        variance += 1.1 / (scene.render.photons * S * radius2 / 4) / (scene.render.passes * scene.render.passes);
        radius2 = nextRadius2(radius2, pass, scene.render.alpha);
    }
    const double direct = 0.5 / pi * 3;
    const double expected = direct * (1 + S * (1 - meanRadius2 / 8));
    const Image image = render(scene, renderPpm).picture;
    double mean = 0;
    for (const glm::vec3& pixel : image.pixels) {
        mean += pixel.x / static_cast<double>(image.pixels.size());
    }
    const double tolerance = 5 * std::sqrt(variance) * direct * S;
    CHECK(tolerance < 0.02 * expected);
    CHECK_THAT(mean, WithinAbs(expected, tolerance));
}

TEST_CASE("a pane shows the light behind it at (1 - F) / (1 + F) on average") {
    // Each path is reflected or refracted at each boundary; it sees the light's 7 or nothing, so the mean of n paths
    // has a standard error of 7 sqrt(T (1 - T) / n), T = 0.96 / 1.04.
    Scene scene = onePixel({0, 0, 5}, {0, 0, 0}, "ppm");
    scene.render.passes = 4000;
    scene.render.photonMap.causticPhotons = 1; // nothing is there for them to light
    const std::size_t glass = addMaterial(scene, Dielectric{1.5});
    addObject(scene, Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, glass);
    addObject(scene, Quad{{-1, -1, -1}, {0, 2, 0}, {2, 0, 0}}, glass);
    addObject(scene, Quad{{-1, -1, -2}, {2, 0, 0}, {0, 2, 0}}, std::nullopt, dvec3(7));
    const double T = 0.96 / 1.04;
    CHECK_THAT(render(scene, renderPpm).picture.pixels[0].x, WithinAbs(7 * T, 5 * 7 * std::sqrt(T * (1 - T) / 4000)));
}

TEST_CASE("a light inside glass is seen from outside at (1 - F) / n^2 of its radiance on average") {
    // A path enters with probability 1 - F and then sees 7 / n^2, or is reflected into the dark: standard error as
    // above.
    Scene scene = onePixel({0, 0, 5}, {0, 0, 0}, "ppm");
    scene.render.passes = 1000;
    scene.render.photonMap.causticPhotons = 1; // nothing is there for them to light
    const std::size_t glass = addMaterial(scene, Dielectric{1.5});
    addObject(scene, Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, glass);
    addObject(scene, Quad{{-1, -1, -2}, {2, 0, 0}, {0, 2, 0}}, std::nullopt, dvec3(7));
    const double seen = 7 / 2.25;
    CHECK_THAT(render(scene, renderPpm).picture.pixels[0].x,
               WithinAbs(0.96 * seen, 5 * seen * std::sqrt(0.96 * 0.04 / 1000)));
}

TEST_CASE("the same scene and seed give the same bits, another seed others") {
    Scene scene = cornellBox();
    const Image first = render(scene, renderPpm).picture;
    CHECK(render(scene, renderPpm).picture.pixels == first.pixels);
    scene.render.seed = 2;
    CHECK(render(scene, renderPpm).picture.pixels != first.pixels);
}

TEST_CASE("a picture rendered on all cores is the mean of its pixels rendered one by one") {
    const Scene scene = cornellBox();
    const World world = prepareWorld(scene);
    SearchRadii radii = firstRadii(world);
    const ProgressiveMaps first = traceProgressive(world, radii, 0);
    for (double* radius : {&radii.global, &radii.caustic}) {
        *radius = std::sqrt(nextRadius2(*radius * *radius, 0, scene.render.alpha));
    }
    const ProgressiveMaps second = traceProgressive(world, radii, 1);
    const Image image = render(scene, renderPpm).picture;
    for (std::uint32_t pixel = 0; pixel < 256; ++pixel) {
        const dvec3 sum = ppmRadiance(world, first, pixel, 0) + ppmRadiance(world, second, pixel, 1);
        CHECK(image.pixels[pixel] == glm::vec3(sum / 2.0));
    }
}

TEST_CASE("rendering may be ended after any pass and gives the mean so far") {
    Scene scene = cornellBox();
    scene.render.passes = 5;
    std::vector<std::uint32_t> calls;
    const LayeredImage stopped =
        render(scene, renderPpm, {.afterPass = [&](std::uint32_t done, const ErrorEstimate& /*error*/) {
                   calls.push_back(done);
                   return done < 2;
               }});
    CHECK(calls == std::vector<std::uint32_t>{1, 2});
    scene.render.passes = 2;
    CHECK(stopped.picture.pixels == render(scene, renderPpm).picture.pixels);
}

TEST_CASE("a scene without light is refused") {
    Scene scene = cornellBox();
    scene.objects[5].emission = dvec3(0);
    CHECK_THROWS_AS(render(scene, renderPpm), Error);
    scene.lights = {{.position = {0, 0, 0}, .intensity = dvec3(0)}};
    CHECK_THROWS_AS(render(scene, renderPpm), Error);
}
