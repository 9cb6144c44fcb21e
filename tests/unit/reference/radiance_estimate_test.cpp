// The radiance estimate from the nearest photons, against analytic values.
#include "reference/photons/radiance_estimate.h"

#include "unit/reference/support.h"

#include <numbers>

using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint32_t kIndirect = 1U << static_cast<std::uint32_t>(PhotonKind::Indirect);

Photon onFloor(const dvec3& position) {
    return {.position = position,
            .direction = {0, 1, 0},
            .normal = {0, 1, 0},
            .power = {1, 2, 3},
            .photon = 0,
            .depth = 2,
            .light = 0,
            .kind = PhotonKind::Indirect};
}

VisiblePoint origin() {
    return {.position = {0, 0, 0},
            .shadowOrigin = {0, 0, 0},
            .normal = {0, 1, 0},
            .geometricNormal = {0, 1, 0},
            .wo = {0, 1, 0},
            .beta = std::numbers::pi * dvec3(0.1, 0.2, 0.3),
            .material = hyalite::Diffuse{dvec3(1)},
            .depth = 1,
            .samplerSeed = 0};
}

RadianceEstimateOptions options(std::size_t nearest, double radius) {
    return {.nearest = nearest, .radius = radius, .kinds = kIndirect, .maxDepth = 12};
}

} // namespace

TEST_CASE("the nearest photons are those of a brute-force search, in order") {
    Random random;
    std::vector<Photon> photons;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        photons.push_back(onFloor(i % 5 == 0 ? dvec3(0.1, 0.2, 0.3) : random.inCube(1)));
        photons.back().depth = 1 + i % 3;
    }
    const PhotonMap map(photons);
    const auto accept = [](const Photon& photon) { return photon.depth != 2; };
    for (std::size_t i = 0; i < 300; ++i) {
        const dvec3 x = i % 10 == 0 ? dvec3(0.1, 0.2, 0.3) : random.inCube(1.2);
        const double radius = random.between(0, 1);
        const std::size_t count = i % 100;
        std::vector<std::pair<double, std::uint32_t>> expected;
        for (std::uint32_t p = 0; p < photons.size(); ++p) {
            const dvec3 way = photons[p].position - x;
            if (accept(photons[p]) && glm::dot(way, way) <= radius * radius) {
                expected.emplace_back(glm::dot(way, way), p);
            }
        }
        std::sort(expected.begin(), expected.end());
        expected.resize(std::min(count, expected.size()));
        std::vector<std::pair<double, std::uint32_t>> actual;
        for (const auto& [distance2, index] : map.nearest(x, count, radius, accept)) {
            actual.emplace_back(distance2, index);
        }
        CHECK(actual == expected);
    }
}

TEST_CASE("the k-th photon sets the radius of the disc and is not counted in it") {
    const PhotonMap map({onFloor({0.1, 0, 0}), onFloor({0, 0, 0.2}), onFloor({0.5, 0, 0}), onFloor({0, 0, 0.6})});
    // Three are asked for: the third, at 1/2, ends a disc with two in it
    const auto three = estimateRadiance(map, origin(), options(3, 1));
    CHECK(three.radius == 0.5);
    checkNear(three.radiance, dvec3(0.1, 0.4, 0.9) * 2.0 / (kPi * 0.25), 1e-14);
    // Five are asked for and four are there, all within the largest disc
    const auto five = estimateRadiance(map, origin(), options(5, 1));
    CHECK(five.radius == 1);
    checkNear(five.radiance, dvec3(0.1, 0.4, 0.9) * 4.0 / kPi, 1e-14);
}

TEST_CASE("photons of other kinds, too far off the plane or on too long a path do not count") {
    Photon caustic = onFloor({0.1, 0, 0});
    caustic.kind = PhotonKind::Caustic;
    Photon distant = onFloor({0.1, 0, 0});
    distant.depth = 12;
    const PhotonMap map({caustic, distant, onFloor({0.1, 0.251, 0})});
    RadianceEstimateOptions coarse = options(5, 1);
    coarse.surfaceError = 1; // no thin sheets
    checkNear(estimateRadiance(map, origin(), coarse).radiance, dvec3(0), 0);
    CHECK(estimateRadiance(PhotonMap({onFloor({0.1, 0.249, 0})}), origin(), coarse).radiance.x > 0);
}

TEST_CASE("in a focus all photons within a pixel count, as many as there are") {
    // Ten photons at the point and three half a pixel away: f * 13 photons over the disc of a pixel's width, 0.02 at a
    // distance of 2 with 0.01 per metre; one beyond it does not count
    std::vector<Photon> photons(10, onFloor({0, 0, 0}));
    photons.insert(photons.end(), 3, onFloor({0.01, 0, 0}));
    photons.push_back(onFloor({0.021, 0, 0}));
    RadianceEstimateOptions pixel = options(5, 1);
    pixel.eye = {0, 2, 0};
    pixel.footprint = 0.01;
    const auto estimate = estimateRadiance(PhotonMap(photons), origin(), pixel);
    CHECK(estimate.radius == 0.02);
    checkNear(estimate.radiance, dvec3(0.1, 0.4, 0.9) * 13.0 / (kPi * 0.0004), 1e-9);
    // Without a camera the disc still has an area
    CHECK(estimateRadiance(PhotonMap(photons), origin(), options(5, 1)).radius == 0x1p-20);
}

TEST_CASE("filter weights are as published, and their means over the disc match sums over rings") {
    RadianceEstimateOptions cone = options(50, 1);
    cone.filter = PhotonFilter::Cone;
    CHECK(filterWeight(cone, 0, 2) == 1);
    CHECK_THAT(filterWeight(cone, 2, 2), WithinAbs(1 - 1 / 1.1, 1e-15));
    RadianceEstimateOptions gauss = options(50, 1);
    gauss.filter = PhotonFilter::Gaussian;
    // At the centre alpha; at the rim 0.918 (1 - (1 - e^-0.9765) / (1 - e^-1.953)) = 0.918 (1 - 0.62337 / 0.85816)
    CHECK_THAT(filterWeight(gauss, 0, 2), WithinAbs(0.918, 1e-15));
    CHECK_THAT(filterWeight(gauss, 2, 2), WithinAbs(0.918 * (1 - 0.62337 / 0.85816), 2e-5));
    for (const RadianceEstimateOptions& filter : {options(50, 1), cone, gauss}) {
        const int rings = 100000;
        double sum = 0; // of weight times 2 d dd over the unit disc: the midpoint rule errs by less than 1e-9
        for (int i = 0; i < rings; ++i) {
            const double d = (i + 0.5) / rings;
            sum += filterWeight(filter, d, 1) * 2 * d / rings;
        }
        CHECK_THAT(meanFilterWeight(filter), WithinAbs(sum, 1e-9));
    }
}

TEST_CASE("a disc that grows past an edge stops where the density began to fall") {
    // Photons at growing distances such that a disc ended by the next of them has the density 1, up to 40 of them; the
    // next are far away. Discs that are compared hold 8, 10, 13, 17, 22, 28, 35, 44 photons: the last is the first to
    // see the gap, and the density has not changed before 35.
    std::vector<Photon> photons;
    for (int i = 0; i < 60; ++i) {
        const double radius = std::sqrt(i / (1000 * kPi)) * (i <= 40 ? 1 : 2);
        photons.push_back(onFloor({radius * std::cos(i), 0, radius * std::sin(i)}));
    }
    const PhotonMap map(photons);
    RadianceEstimateOptions checked = options(50, 1);
    checked.maxChange = 0.2;
    const auto expected = dvec3(0.1, 0.4, 0.9) * 1000.0;
    const auto estimate = estimateRadiance(map, origin(), checked);
    // Photon i, from 0, lies on the rim of the disc that holds the i before it
    CHECK(estimate.radius < std::sqrt(36 / (1000 * kPi)));
    checkNear(estimate.radiance, expected, 1e-9);
    CHECK(estimateRadiance(map, origin(), options(50, 1)).radiance.x < 0.5 * expected.x);
}
