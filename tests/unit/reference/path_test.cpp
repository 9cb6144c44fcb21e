// Path tracing against analytic series.
#include "reference/integrators/path.h"

#include "unit/reference/furnace.h"

#include <cmath>
#include <numbers>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

using std::numbers::pi;

struct Estimate {
    double mean = 0;
    double deviation = 0; // of the mean, as if the samples were independent: stratified ones deviate less
};

Estimate estimate(const World& world, std::uint32_t samples) {
    double sum = 0;
    double squares = 0;
    for (std::uint32_t pass = 0; pass < samples; ++pass) {
        const double L = pathRadiance(world, 0, pass).x;
        sum += L;
        squares += L * L;
    }
    const double mean = sum / samples;
    return {mean, std::sqrt((squares / samples - mean * mean) / samples)};
}

// A diffuse sphere of radius 1 with a point light of intensity 1 in its middle.
Scene litSphere(double albedo, std::uint32_t maxDepth) {
    Scene scene = onePixel({0.2, 0.1, 0}, {1, 0.3, 0.2}, "path");
    scene.render.maxDepth = maxDepth;
    scene.lights = {{.position = {0, 0, 0}, .intensity = dvec3(1)}};
    addObject(scene, Sphere{{0, 0, 0}, 1}, addMaterial(scene, Diffuse{dvec3(albedo)}));
    return scene;
}

// A closed cube whose walls are diffuse and emit radiance 1 inwards.
Scene furnace(double albedo, std::uint32_t maxDepth) {
    Scene scene = onePixel({0, 0, 0}, {0.3, 0.2, 1}, "path");
    scene.render.maxDepth = maxDepth;
    addFurnace(scene, albedo);
    return scene;
}

} // namespace

TEST_CASE("in a sphere lit from its centre direct light is albedo / pi times the intensity") {
    // E = I / r^2 = 1, seen under normal incidence everywhere: L = albedo / pi. No random number changes it.
    const World world = prepareWorld(litSphere(0.5, 2));
    for (std::uint32_t pass = 0; pass < 10; ++pass) {
        CHECK_THAT(pathRadiance(world, 0, pass).x, WithinRel(0.5 / pi, 1e-9));
    }
    CHECK(pathRadiance(prepareWorld(litSphere(0.5, 1)), 0, 0) == dvec3(0)); // a point light cannot be seen
}

TEST_CASE("in a sphere of albedo 1/2 lit from its centre radiance is I / pi, or its truncated series") {
    // The sphere sees itself evenly: each bounce brings albedo times the one before. After n segments
    // L = 1/pi (1/2 + 1/4 + ... + 2^-(n-1)); without an end 1/pi.
    for (const std::uint32_t maxDepth : {3U, 5U, 100U}) {
        const Estimate e = estimate(prepareWorld(litSphere(0.5, maxDepth)), 20000);
        const double expected = (1 - std::pow(0.5, maxDepth - 1.0)) / pi;
        CHECK(e.deviation < 0.01 * expected);
        CHECK(std::abs(e.mean - expected) < 5 * e.deviation);
    }
}

TEST_CASE("in a closed furnace radiance is 1 / (1 - albedo), or its truncated series") {
    // Every direction from every point brings radiance 1 times the series 1 + a + a^2 + ...; n segments are n terms
    for (const double albedo : {0.3, 0.8}) {
        for (const std::uint32_t maxDepth : {1U, 2U, 3U, 60U}) {
            const Estimate e = estimate(prepareWorld(furnace(albedo, maxDepth)), 20000);
            const double expected = (1 - std::pow(albedo, maxDepth)) / (1 - albedo);
            INFO("albedo " << albedo << ", depth " << maxDepth << ", mean " << e.mean << " +- " << e.deviation);
            CHECK(e.deviation < 0.02 * expected);
            CHECK(std::abs(e.mean - expected) <= 5 * e.deviation + 1e-9);
        }
    }
}

TEST_CASE("light seen through a pane or in a mirror is counted once") {
    // Mirror of reflectance 0.5 at 45 degrees between the camera and a light of radiance 1
    Scene scene = onePixel({0, 0, 3}, {0, 0, 0}, "path");
    addObject(scene, Quad{{-1, -1, -1}, {2, 0, 2}, {0, 2, 0}}, addMaterial(scene, Mirror{dvec3(0.5)}));
    addObject(scene, Quad{{-3, -1, -1}, {0, 2, 0}, {0, 0, 2}}, std::nullopt, dvec3(1));
    CHECK_THAT(pathRadiance(prepareWorld(scene), 0, 0).x, WithinRel(0.5, 1e-9));
}

TEST_CASE("a rough white ball in a room of light shows the albedo of its facets") {
    // F = 1 everywhere, seen along the normal: facets of slope t reflect to 2 t, and the light that the far side masks
    // is lost. Their density is D(t) cos t, so that L is the integral of D cos t G1(2 t) over the t up to 45 degrees,
    // with D = a^2 / (pi (1 + (a^2 - 1) cos^2 t)^2) and G1 = 2 / (1 + sqrt(1 + a^2 tan^2)) [Walter07].
    Scene scene = onePixel({0, 0, 3}, {0, 0, 0}, "path");
    scene.environment = Environment{.image = Image(1, 1)};
    scene.environment->image.pixels[0] = glm::vec3(1);
    addObject(scene, Sphere{{0, 0, 0}, 1}, addMaterial(scene, MetallicRoughness{dvec3(1), 1, 0.3}));
    const double a2 = std::pow(0.09, 2);
    double expected = 0;
    constexpr int kSteps = 10000;
    for (int i = 0; i < kSteps; ++i) {
        const double t = (i + 0.5) * pi / 4 / kSteps;
        const double c2 = std::cos(t) * std::cos(t);
        const double D = a2 / (pi * std::pow(1 + (a2 - 1) * c2, 2));
        const double G1 = 2 / (1 + std::sqrt(1 + a2 * std::pow(std::tan(2 * t), 2)));
        expected += D * std::cos(t) * G1 * 2 * pi * std::sin(t) * (pi / 4 / kSteps);
    }
    CHECK_THAT(expected, WithinAbs(0.99, 0.005)); // as the documentation says
    const Estimate e = estimate(prepareWorld(scene), 20000);
    INFO("mean " << e.mean << " +- " << e.deviation << ", expected " << expected);
    CHECK(e.deviation < 0.002);
    CHECK(std::abs(e.mean - expected) < 5 * e.deviation);
}

TEST_CASE("a white coated ball in a room of light is almost white") {
    // The coat reflects F(cosine) on average over the facets, at least 0.04; what enters it comes out again but for the
    // facets' losses: with a smooth coat L = F + (1 - F) = 1 where the base is white, seen along the normal.
    Scene scene = onePixel({0, 0, 3}, {0, 0, 0}, "path");
    scene.environment = Environment{.image = Image(1, 1)};
    scene.environment->image.pixels[0] = glm::vec3(1);
    addObject(scene, Sphere{{0, 0, 0}, 1}, addMaterial(scene, MetallicRoughness{dvec3(1), 0, 0}));
    const Estimate e = estimate(prepareWorld(scene), 20000);
    INFO("mean " << e.mean << " +- " << e.deviation);
    CHECK(e.deviation < 0.01);
    CHECK(std::abs(e.mean - 1) < 5 * e.deviation);
}
