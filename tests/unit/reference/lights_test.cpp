// Light flux, choice and sampling against closed forms.
#include "reference/lights/lights.h"
#include "reference/photons/photons.h"

#include "reference/integrators/shading.h"
#include "unit/reference/support.h"

#include <cmath>
#include <numbers>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

using std::numbers::pi;

Scene twoLights() {
    Scene scene;
    scene.lights = {{.position = {0, 1, 0}, .intensity = {1, 2, 3}}};
    addObject(scene, Quad{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}, std::nullopt, {4, 4, 4});
    return scene;
}

// A point on the floor y = 0 with normal y and f = albedo / pi for albedo 1.
VisiblePoint floorPoint() {
    return {.position = {0, 0, 0},
            .shadowOrigin = {0, 0, 0},
            .normal = {0, 1, 0},
            .geometricNormal = {0, 1, 0},
            .wo = {0, 1, 0},
            .beta = dvec3(1),
            .material = Diffuse{dvec3(1)},
            .depth = 1,
            .samplerSeed = 8}; // even: Sobol points
}

} // namespace

TEST_CASE("lights are points, then emitting quads, picked half by the mean flux and half evenly") {
    const std::vector<Light> lights = makeLights(twoLights());
    REQUIRE(lights.size() == 2);
    checkNear(lights[0].power, 4 * pi * dvec3(1, 2, 3), 1e-13); // over the whole sphere
    checkNear(lights[1].power, dvec3(pi * 6 * 4), 1e-13);       // pi A L with A = 2 * 3
    // means 8 pi and 24 pi: a quarter and three quarters, averaged with a half
    CHECK_THAT(lights[0].pmf, WithinAbs(0.375, 1e-15));
    CHECK_THAT(lights[1].pmf, WithinAbs(0.625, 1e-15));
    CHECK(lights[1].cdf == 1);
    CHECK(chooseLight(lights, 0) == 0);
    CHECK(chooseLight(lights, 0.3749) == 0);
    CHECK(chooseLight(lights, 0.3751) == 1);
    CHECK(chooseLight(lights, 1 - 0x1p-24) == 1);
}

TEST_CASE("an emitting torus is refused with its place in the file") {
    Scene scene;
    addObject(scene, Torus{}, std::nullopt, {1, 1, 1});
    scene.objects[0].where = {.file = "scene.yaml", .line = 3, .column = 5};
    try {
        (void)makeLights(scene);
        FAIL("accepted");
    } catch (const Error& error) {
        CHECK(error.code() == ExitCode::BadInput);
        CHECK(error.where().line == 3);
    }
}

TEST_CASE("the power of an area is pi A L") {
    // A = pi 2 * 3 for an ellipse of half axes 2 and 3, 4 pi 0.5^2 = pi for a sphere of radius one half
    Scene scene;
    addObject(scene, Disk{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}, std::nullopt, {1, 2, 3});
    addObject(scene, Sphere{{0, 0, 0}, 0.5}, std::nullopt, {1, 0, 0});
    const std::vector<Light> lights = makeLights(scene);
    checkNear(lights.at(0).power, 6 * pi * pi * dvec3(1, 2, 3), 1e-12);
    checkNear(lights.at(1).power, pi * pi * dvec3(1, 0, 0), 1e-12);
    // Half in proportion to the mean of the channels, 36 to 1, and half evenly
    CHECK_THAT(lights.at(0).pmf, WithinRel((36.0 / 37.0 + 0.5) / 2, 1e-12));
}

TEST_CASE("a point light contributes f I cos / d^2") {
    Scene scene;
    scene.lights = {{.position = {1, 2, 0}, .intensity = {5, 10, 20}}};
    const World world = prepareWorld(scene);
    const auto sample = sampleLight(world, floorPoint(), 0, std::nullopt);
    REQUIRE(sample);
    // d^2 = 5, cos = 2 / sqrt 5
    checkNear(sample->contribution, dvec3(5, 10, 20) / pi * 2.0 / (5 * std::sqrt(5.0)), 1e-14);
    CHECK(sample->to == dvec3(1, 2, 0));
}

TEST_CASE("a light below the surface, or a quad seen from behind, contributes nothing") {
    Scene below;
    below.lights = {{.position = {1, -2, 0}, .intensity = {1, 1, 1}}};
    CHECK_FALSE(sampleLight(prepareWorld(below), floorPoint(), 0, 0));
    Scene behind; // z cross x = y: emits upwards
    addObject(behind, Quad{{-1, 1, -1}, {0, 0, 2}, {2, 0, 0}}, std::nullopt, {1, 1, 1});
    CHECK_FALSE(sampleLight(prepareWorld(behind), floorPoint(), 0, 0));
}

TEST_CASE("samples of a square light average to its form factor") {
    // A square of half-width a at height h above the point, parallel: four corner rectangles, each with the form factor
    // 1/(2 pi) (X / sqrt(1 + X^2) atan(X / sqrt(1 + X^2)) * 2), X = a / h. With albedo 1, L = Le * F.
    const double X = 0.5;
    const double s = X / std::sqrt(1 + X * X);
    const double formFactor = 4 / (2 * pi) * 2 * s * std::atan(s);
    Scene scene; // x cross z = -y: emits downwards
    addObject(scene, Quad{{-1, 2, -1}, {2, 0, 0}, {0, 0, 2}}, std::nullopt, {3, 3, 3});
    const World world = prepareWorld(scene);
    constexpr std::uint32_t kPasses = 4096;
    double sum = 0;
    double sum2 = 0;
    for (std::uint32_t pass = 0; pass < kPasses; ++pass) {
        const auto sample = sampleLight(world, floorPoint(), shared::kCameraSequences * pass, 0);
        REQUIRE(sample);
        sum += sample->contribution.x;
        sum2 += sample->contribution.x * sample->contribution.x;
    }
    const double mean = sum / kPasses;
    // Five standard errors of independent samples; scrambled Sobol points do better.
    const double standardError = std::sqrt((sum2 / kPasses - mean * mean) / kPasses);
    CHECK_THAT(mean, WithinAbs(3 * formFactor, 5 * standardError));
    CHECK(standardError < 0.01 * mean); // the bound above is a sharp one
}

TEST_CASE("one light picked in proportion to power gives the sum over all lights on average") {
    Scene scene;
    scene.lights = {{.position = {0, 1, 0}, .intensity = dvec3(1)},
                    {.position = {0, 2, 0}, .intensity = dvec3(3)},
                    {.position = {0, -1, 0}, .intensity = dvec3(4)}}; // below: picked half of the time, gives nothing
    const World world = prepareWorld(scene);
    // Exactly: 1/pi (1 / 1 + 3 / 4). With n stratified choices every pmf is met to within 1 / n: contributions
    // 1 / (1/8) and 0.75 / (3/8) over pi, so the error is at most (8 + 2) / (pi n).
    constexpr std::uint32_t kPasses = 1024;
    double sum = 0;
    for (std::uint32_t pass = 0; pass < kPasses; ++pass) {
        const auto sample = sampleLight(world, floorPoint(), shared::kCameraSequences * pass, std::nullopt);
        sum += sample ? sample->contribution.x : 0;
    }
    CHECK_THAT(sum / kPasses, WithinAbs(1.75 / pi, 10 / (pi * kPasses)));
}

TEST_CASE("the photons of a pass carry the flux of the lights") {
    Scene scene = twoLights();
    scene.render.photons = 4096;
    const World world = prepareWorld(scene);
    dvec3 sum(0);
    int fromPoint = 0;
    for (std::uint32_t photon = 0; photon < 4096; ++photon) {
        const Emission emission = emitPhoton(world, photon, progressivePass(world, 3));
        sum += emission.power;
        if (emission.ray.origin == dvec3(0, 1, 0)) {
            ++fromPoint;
        } else { // from the front of the quad z = 0, forwards
            CHECK(emission.ray.direction.z > 0);
            CHECK_THAT(emission.ray.origin.z, WithinAbs(0, 1e-12));
            CHECK(emission.ray.origin.z > 0);
            CHECK(emission.ray.origin.x <= 2);
            CHECK(emission.ray.origin.y <= 3);
        }
    }
    // 4096 Sobol numbers put exactly three eighths below cdf = 3/8, to within one at the border.
    CHECK(std::abs(fromPoint - 1536) <= 1);
    // One photon more or less at the border moves the sum by less than 1 / 1024 of a light's flux.
    checkNear(sum, 4 * pi * dvec3(1, 2, 3) + dvec3(24 * pi), 2 * glm::length(dvec3(24 * pi)) / 1024);
}

TEST_CASE("photons leave a point light uniformly and a quad cosine-weighted") {
    Scene point;
    point.lights = {{.position = {0, 0, 0}, .intensity = dvec3(1)}};
    point.render.photons = 4096;
    Scene quad;
    addObject(quad, Quad{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, std::nullopt, dvec3(1));
    quad.render.photons = 4096;
    const auto meanDirection = [](const Scene& scene) {
        const World world = prepareWorld(scene);
        dvec3 sum(0);
        for (std::uint32_t photon = 0; photon < 4096; ++photon) {
            sum += emitPhoton(world, photon, progressivePass(world, 0)).ray.direction;
        }
        return sum / 4096.0;
    };
    // Means 0 and 2/3 n; a component's variance is at most 1/3, so five standard errors of 4096 independent draws are
    // 5 sqrt(1/3 / 4096) = 0.045.
    checkNear(meanDirection(point), {0, 0, 0}, 0.045);
    checkNear(meanDirection(quad), {0, 0, 2.0 / 3}, 0.045);
}
