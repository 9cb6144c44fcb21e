// The environment's image: its orientation, and the sampling of directions.
#include "reference/lights/environment.h"

#include "reference/integrators/whitted.h"
#include "reference/lights/lights.h"
#include "reference/world.h"
#include "unit/reference/support.h"

#include <cmath>
#include <numbers>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

using glm::vec3;
using std::numbers::pi;

// Colours that differ in every pixel by as much as 1 to 40, some of them black.
Environment patchwork() {
    Environment environment{.image = Image(8, 4)};
    Random random;
    for (vec3& pixel : environment.image.pixels) {
        const double strength = random.unit() < 0.2 ? 0 : random.between(0.1, 4);
        pixel = strength * dvec3(random.between(0.5, 1), random.between(0.5, 1), random.between(0.5, 1));
    }
    return environment;
}

// The pixel of a direction, from the format's definition alone: azimuth from left to right with -z in the middle and +x
// in the right quarter.
std::size_t pixelOf(const dvec3& d, int width, int height) {
    const double u = 0.5 + std::atan2(d.x, -d.z) / (2 * pi);
    const double v = std::acos(d.y) / pi;
    const int x = std::min(static_cast<int>(u * width), width - 1);
    const int y = std::min(static_cast<int>(v * height), height - 1);
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

} // namespace

TEST_CASE("the middle of the image is seen along -z, its right quarter along +x and its top upwards") {
    Environment environment{.image = Image(4, 2)};
    for (int i = 0; i < 8; ++i) {
        environment.image.pixels[static_cast<std::size_t>(i)] = vec3(float(i));
    }
    const auto seen = [&](const dvec3& direction) {
        return EnvironmentLight(environment).radiance(glm::normalize(direction)).x;
    };
    // Columns 0 to 3 are centred at azimuths -135, -45, 45, 135 degrees from -z towards +x
    CHECK(seen({-1, 1, 1}) == 0);
    CHECK(seen({-1, 1, -1}) == 1);
    CHECK(seen({1, 1, -1}) == 2);
    CHECK(seen({1, 1, 1}) == 3);
    CHECK(seen({-1, -1, -1}) == 5);
    // Turned by 90 degrees about y, as the axes are: what was seen along -z is seen along -x
    environment.rotation = 90;
    CHECK(seen({-1, 1, 1}) == 1);
    CHECK(seen({-1, 1, -1}) == 2);
    environment.scale = 10;
    CHECK(seen({-1, 1, -1}) == 20);
}

TEST_CASE("a constant environment has the integral 4 pi L, and half of it half of that") {
    Environment environment{.image = Image(16, 8), .scale = 0.5};
    for (vec3& pixel : environment.image.pixels) {
        pixel = vec3(2, 4, 6);
    }
    checkNear(EnvironmentLight(environment).integral(), 4 * pi * dvec3(1, 2, 3), 1e-12);
    for (std::size_t i = 0; i < 64; ++i) {
        environment.image.pixels[i] = vec3(0); // the upper half
    }
    checkNear(EnvironmentLight(environment).integral(), 2 * pi * dvec3(1, 2, 3), 1e-12);
}

TEST_CASE("directions are sampled in proportion to the radiance of the image, by a chi-square test") {
    const Environment environment = patchwork();
    const EnvironmentLight light(environment);
    constexpr int kCount = 100000;
    std::vector<int> found(32, 0);
    Random random;
    for (int i = 0; i < kCount; ++i) {
        const dvec3 d = light.sample({random.unit(), random.unit()});
        CHECK_THAT(glm::length(d), WithinAbs(1, 1e-12));
        ++found[pixelOf(d, 8, 4)];
    }
    // Mean of the channels times solid angle over the sum of these
    std::vector<double> expected;
    double total = 0;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 8; ++x) {
            const dvec3 c(environment.image.at(x, y));
            const double solidAngle = pi / 4 * (std::cos(pi * y / 4) - std::cos(pi * (y + 1) / 4));
            expected.push_back((c.x + c.y + c.z) / 3 * solidAngle);
            total += expected.back();
        }
    }
    double chiSquare = 0;
    int cells = 0;
    for (std::size_t i = 0; i < 32; ++i) {
        const double mean = expected[i] / total * kCount;
        if (mean == 0) {
            CHECK(found[i] == 0);
            continue;
        }
        chiSquare += (found[i] - mean) * (found[i] - mean) / mean;
        ++cells;
    }
    // Mean and variance of chi-square are k and 2 k with k = cells - 1: five deviations
    CHECK(cells > 20);
    CHECK(chiSquare < cells - 1 + 5 * std::sqrt(2.0 * (cells - 1)));
}

TEST_CASE("the density of a direction integrates to 1 and is that of the samples") {
    const EnvironmentLight light(patchwork());
    // The integral of g over the sphere is the mean of g / pdfW over the samples where the map is not black. For g =
    // the density itself that mean is exactly 1; over the evenly spread directions the mean of pdfW times 4 pi is 1
    Random random;
    constexpr int kCount = 50000;
    double sum = 0;
    double sum2 = 0;
    for (int i = 0; i < kCount; ++i) {
        const double value = 4 * pi * light.pdfW(random.direction());
        sum += value;
        sum2 += value * value;
    }
    const double mean = sum / kCount;
    CHECK_THAT(mean, WithinAbs(1, 5 * std::sqrt((sum2 / kCount - mean * mean) / kCount)));
}

TEST_CASE("a floor under a constant environment has the irradiance pi L") {
    Scene scene;
    scene.environment = Environment{.image = Image(1, 1)};
    scene.environment->image.at(0, 0) = vec3(1, 2, 3);
    const World world = prepareWorld(scene);
    VisiblePoint x{.position = {0, 0, 0},
                   .shadowOrigin = {0, 0, 0},
                   .normal = {0, 1, 0},
                   .geometricNormal = {0, 1, 0},
                   .wo = {0, 1, 0},
                   .beta = dvec3(1),
                   .material = Diffuse{dvec3(1)},
                   .depth = 1,
                   .samplerSeed = 8}; // even: Sobol points
    constexpr std::uint32_t kPasses = 4096;
    dvec3 sum(0);
    for (std::uint32_t pass = 0; pass < kPasses; ++pass) {
        const auto sample = sampleLight(world, x, shared::kCameraSequences * pass, 0);
        sum += sample ? sample->contribution : dvec3(0);
    }
    // A sample is 4 L cos above the floor, 0 below: mean L, variance 16/6 - 1 = 1.67 L^2. Independent, five standard
    // errors are 5 * 1.29 / 64 = 0.1 L; the Sobol numbers do much better
    checkNear(sum / double(kPasses), dvec3(1, 2, 3), 0.01 * glm::length(dvec3(1, 2, 3)));
}

TEST_CASE("objects without absorption are invisible in a uniform environment") {
    // A mirror ball and a glass one: every path ends in the environment, with its whole radiance
    for (const MaterialModel& model : {MaterialModel(Mirror{dvec3(1)}), MaterialModel(Dielectric{1.5})}) {
        Scene scene = onePixel({0, 0.3, 3}, {0, 0.2, 0}, "whitted");
        scene.render.maxDepth = 30;
        scene.render.minWeight = 0;
        scene.environment = Environment{.image = Image(1, 1), .scale = 3};
        scene.environment->image.at(0, 0) = vec3(1);
        addObject(scene, Sphere{{0, 0, 0}, 1}, addMaterial(scene, model));
        // 30 reflections inside glass leave 0.04^15 of the light at most
        checkNear(whittedRadiance(prepareWorld(scene), 0, 0), dvec3(3), 1e-9);
    }
}
