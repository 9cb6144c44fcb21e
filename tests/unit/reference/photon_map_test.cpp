// Finding photons and estimating radiance from them.
#include "reference/photons/photon_map.h"

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
            .wo = {0, 1, 0},
            .beta = std::numbers::pi * dvec3(0.1, 0.2, 0.3),
            .material = hyalite::Diffuse{dvec3(1)},
            .depth = depth,
            .samplerSeed = 0};
}

} // namespace

TEST_CASE("the map finds the photons of a brute-force search, in ascending order") {
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

TEST_CASE("the overlap of a disc and a parallelogram follows plane geometry") {
    // A strip of width w, much longer than the disc: about its middle line the disc shares 2 (h sqrt(r^2 - h^2) + r^2
    // asin(h / r)) with it, h = w / 2.
    const double pi = std::numbers::pi;
    const hyalite::Quad square{{0, 0, 0}, {0, 0, 2}, {2, 0, 0}};
    CHECK_THAT(discOnQuad(square, {1, 0, 1}, 0.9), WithinRel(pi * 0.81, 1e-12));
    CHECK_THAT(discOnQuad(square, {1, 0, 1}, 2), WithinRel(4, 1e-12)); // all of it
    CHECK_THAT(discOnQuad(square, {0, 0, 1}, 0.5), WithinRel(pi * 0.25 / 2, 1e-12));
    CHECK_THAT(discOnQuad(square, {2, 0, 0}, 0.5), WithinRel(pi * 0.25 / 4, 1e-12));
    // A corner of 60 degrees holds a sixth of the disc
    const hyalite::Quad rhomb{{0, 0, 0}, {2, 0, 0}, {1, 0, -std::sqrt(3.0)}};
    CHECK_THAT(discOnQuad(rhomb, {0, 0, 0}, 1), WithinRel(pi / 6, 1e-12));
    const hyalite::Quad strip{{-50, 3, -0.1}, {0, 0, 0.2}, {100, 0, 0}};
    const double h = 0.1;
    const double r = 0.7;
    CHECK_THAT(discOnQuad(strip, {0, 3, 0}, r),
               WithinRel(2 * (h * std::sqrt(r * r - h * h) + r * r * std::asin(h / r)), 1e-12));
    // By chance: a slanted parallelogram, its area times the share of its points that lie in the disc
    Random random;
    const hyalite::Quad slanted{{-0.5, 0, -0.4}, {1.1, 0.3, 0.2}, {-0.3, 0.2, 0.9}};
    const double whole = glm::length(glm::cross(slanted.edge0, slanted.edge1));
    for (int trial = 0; trial < 20; ++trial) {
        const dvec3 at = random.inCube(0.5) + 0.5;
        const dvec3 center = slanted.corner + at.x * slanted.edge0 + at.y * slanted.edge1;
        int within = 0;
        constexpr int kPoints = 40000;
        for (int i = 0; i < kPoints; ++i) {
            const dvec3 uv = random.inCube(0.5) + 0.5;
            within += glm::distance(slanted.corner + uv.x * slanted.edge0 + uv.y * slanted.edge1, center) < 0.45;
        }
        const double share = static_cast<double>(within) / kPoints;
        // Five standard errors
        CHECK_THAT(discOnQuad(slanted, center, 0.45),
                   WithinAbs(whole * share, 5 * whole * std::sqrt(share * (1 - share) / kPoints)));
    }
}

TEST_CASE("a photon exactly on the rim counts") {
    const PhotonMap map({onFloor({0.5, 0, 0}), onFloor({0, 0, 0.5000001})});
    CHECK(map.near({0, 0, 0}, 0.5) == std::vector<std::uint32_t>{0});
}

TEST_CASE("an empty map gives no radiance") {
    checkNear(gatherRadiance(PhotonMap({}), origin(1), 1, 12, 0), {0, 0, 0}, 0);
}

TEST_CASE("radiance is f times the flux over the disc's area") {
    // Two photons of (1, 2, 3) W within r = 1/2: f * (2, 4, 6) / (pi / 4).
    const PhotonMap map({onFloor({0.1, 0, 0}), onFloor({0, 0, -0.3}), onFloor({0.6, 0, 0})});
    checkNear(gatherRadiance(map, origin(1), 0.5, 12, 0), dvec3(0.2, 0.8, 1.8) * 4.0 / std::numbers::pi, 1e-15);
}

TEST_CASE("photons off the plane, on a turned or opposite surface, from below, or on too long a path do not count") {
    const auto counts = [](const Photon& photon, std::uint32_t cameraDepth) {
        return gatherRadiance(PhotonMap({photon}), origin(cameraDepth), 1, 12, 1) != dvec3(0);
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

TEST_CASE(
    "a photon on a parallel sheet does not count, however thin the gap; on a plane, a sphere or past an edge it does") {
    const auto counts = [](const dvec3& position, const dvec3& normal) {
        Photon photon = onFloor(position);
        photon.normal = glm::normalize(normal);
        photon.direction = photon.normal;
        return isOnSide(photon, origin(1), 1e-6);
    };
    CHECK(counts({0.3, 0, 0.4}, {0, 1, 0}));
    // A millimetre below, up to a metre aside
    CHECK_FALSE(counts({0.99, -0.001, 0}, {0, 1, 0}));
    CHECK_FALSE(counts({0, 0.001, 0}, {0, 1, 0}));
    CHECK_FALSE(counts({0.5, -0.05, 0.5}, {0, 1, 0}));
    CHECK_FALSE(counts({0.01, -0.01, 0}, {0.01, 1, 0})); // hardly tilted
    // On the sphere of radius 1 about (0, -1, 0), up to 57 degrees away
    for (const double angle : {0.01, 0.3, 1.0}) {
        const dvec3 normal{std::sin(angle), std::cos(angle), 0};
        CHECK(counts(normal - dvec3(0, 1, 0), normal));
    }
    // 0.2 past an edge 0.1 away, behind which the surface falls or rises by 30 degrees
    const double c = std::sqrt(0.75);
    CHECK(counts({0.1 + 0.2 * c, -0.1, 0}, {0.5, c, 0}));
    CHECK(counts({0.1 + 0.2 * c, 0.1, 0}, {-0.5, c, 0}));
}

TEST_CASE("the nearest irradiance record counts that is on the surface and whose disc holds the place") {
    const auto record = [](const dvec3& position, double discRadius, double E) {
        Photon photon = onFloor(position);
        photon.power = dvec3(E);
        photon.discRadius = discRadius;
        return photon;
    };
    // The first lies under the floor, and the disc of the second ends before the origin
    const PhotonMap records({record({0.01, -0.05, 0}, 1, 1), record({0.1, 0, 0}, 0.09, 2), record({0, 0, 0.2}, 0.3, 3),
                             record({0.25, 0, 0}, 0.3, 4)});
    const auto nearest = recordedIrradiance(records, origin(1), 1, 1e-6);
    REQUIRE(nearest);
    checkNear(*nearest, dvec3(3), 0);
    CHECK_FALSE(recordedIrradiance(records, origin(1), 0.15, 1e-6));
}

TEST_CASE("the overlap of a disc and a round disk follows plane geometry") {
    const double pi = std::numbers::pi;
    const hyalite::Disk disk{.center = {0, 0, 0}, .axis0 = {2, 0, 0}, .axis1 = {0, 0, -2}};
    const auto area = [&](const dvec3& at, double radius) {
        VisiblePoint x = origin(1);
        x.position = at;
        x.disk = &disk;
        return discOnSurface(x, radius);
    };
    CHECK_THAT(area({1, 0, 0}, 0.9), WithinRel(pi * 0.81, 1e-12)); // inside
    CHECK_THAT(area({0.1, 0, 0.2}, 5), WithinRel(pi * 4, 1e-12));  // all of it
    // Two circles through each other's centres: R^2 (2 pi / 3 - sqrt(3) / 2)
    CHECK_THAT(area({2, 0, 0}, 2), WithinRel(4 * (2 * pi / 3 - std::sqrt(0.75)), 1e-12));
    CHECK_THAT(area({0, 0, 2}, 1e-3), WithinRel(pi * 1e-6 / 2, 1e-3)); // nearly a straight edge
}
