// Finding photons and estimating radiance from them.
#include "reference/photon_map.h"

#include "unit/reference/support.h"

#include <numbers>

using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

Photon onFloor(const dvec3& position) {
    return {
        .position = position, .direction = {0, 1, 0}, .normal = {0, 1, 0}, .power = {1, 2, 3}, .photon = 0, .depth = 2};
}

VisiblePoint origin(std::uint32_t depth) {
    return {.position = {0, 0, 0},
            .shadowOrigin = {0, 0, 0},
            .normal = {0, 1, 0},
            .geometricNormal = {0, 1, 0},
            .f = {0.1, 0.2, 0.3},
            .depth = depth,
            .samplerSeed = 0};
}

} // namespace

TEST_CASE("the map finds the photons that asking every photon finds, in ascending order") {
    Random random;
    std::vector<Photon> photons;
    photons.reserve(5000);
    for (int i = 0; i < 5000; ++i) {
        photons.push_back(onFloor(random.inCube(1)));
    }
    const PhotonMap map(photons);
    std::size_t found = 0;
    for (int i = 0; i < 500; ++i) {
        const dvec3 x = random.inCube(1.2);
        const double radius = random.between(0, 0.5);
        std::vector<std::uint32_t> expected;
        for (std::uint32_t p = 0; p < photons.size(); ++p) {
            const dvec3 way = photons[p].position - x;
            if (glm::dot(way, way) <= radius * radius) {
                expected.push_back(p);
            }
        }
        found += expected.size();
        CHECK(map.near(x, radius) == expected);
    }
    CHECK(found > 500);
}

TEST_CASE("a photon exactly on the rim counts") {
    const PhotonMap map({onFloor({0.5, 0, 0}), onFloor({0, 0, 0.5000001})});
    CHECK(map.near({0, 0, 0}, 0.5) == std::vector<std::uint32_t>{0});
}

TEST_CASE("an empty map gives no radiance") {
    checkNear(gatherRadiance(PhotonMap({}), origin(1), 1, 12), {0, 0, 0}, 0);
}

TEST_CASE("radiance is f times the flux over the disc's area") {
    // Two photons of (1, 2, 3) W within r = 1/2: f * (2, 4, 6) / (pi / 4).
    const PhotonMap map({onFloor({0.1, 0, 0}), onFloor({0, 0, -0.3}), onFloor({0.6, 0, 0})});
    checkNear(gatherRadiance(map, origin(1), 0.5, 12), dvec3(0.2, 0.8, 1.8) * 4.0 / std::numbers::pi, 1e-15);
}

TEST_CASE("photons off the plane, on a turned or opposite surface, from below, or on too long a path do not count") {
    const auto counts = [](const Photon& photon, std::uint32_t cameraDepth) {
        return gatherRadiance(PhotonMap({photon}), origin(cameraDepth), 1, 12) != dvec3(0);
    };
    const auto with = [](auto change) {
        Photon photon = onFloor({0.1, 0, 0});
        change(photon);
        return photon;
    };
    CHECK(counts(onFloor({0.1, 0, 0}), 1));
    CHECK(counts(onFloor({0.1, 0.249, 0}), 1)); // a quarter of the radius
    CHECK_FALSE(counts(onFloor({0.1, 0.251, 0}), 1));
    CHECK_FALSE(counts(onFloor({0.1, -0.251, 0}), 1));
    CHECK(counts(with([](Photon& p) { p.normal = glm::normalize(dvec3(1, 0.6, 0)); }), 1));        // 59 degrees
    CHECK_FALSE(counts(with([](Photon& p) { p.normal = glm::normalize(dvec3(1, 0.57, 0)); }), 1)); // 60.3 degrees
    CHECK_FALSE(counts(with([](Photon& p) { p.normal = {0, -1, 0}; }), 1));
    CHECK_FALSE(counts(with([](Photon& p) { p.direction = glm::normalize(dvec3(1, -0.01, 0)); }), 1));
    CHECK(counts(with([](Photon& p) { p.depth = 9; }), 3)); // 12 segments
    CHECK_FALSE(counts(with([](Photon& p) { p.depth = 10; }), 3));
}
