// Lines against a torus: analytic crossings, and every crossing of random lines against sampling.
#include "reference/shapes/torus.h"

#include "unit/reference/random_solids.h"

#include <cmath>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

const Torus kRing{.major = 1, .minor = 0.25, .objectToWorld = glm::dmat4(1)};

void checkCrossings(const Torus& torus, const Ray& line, const std::vector<double>& expected,
                    double tolerance = 1e-14) {
    const Crossings actual = crossings(WorldTorus(torus), line);
    REQUIRE(actual.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CHECK_THAT(actual[i].at.t, WithinAbs(expected[i], tolerance));
        CHECK(actual[i].entering == (i % 2 == 0));
    }
}

// Distance from the circle in the tube, less the tube's radius.
double distanceFrom(const Torus& torus, const dvec3& p) {
    return std::hypot(std::hypot(p.x, p.z) - torus.major, p.y) - torus.minor;
}

} // namespace

TEST_CASE("a line in the ring's plane crosses both sides of the tube") {
    // |x| from 0.75 to 1.25, seen from x = -3
    checkCrossings(kRing, {.origin = {-3, 0, 0}, .direction = {1, 0, 0}}, {1.75, 2.25, 3.75, 4.25});
    checkCrossings(kRing, {.origin = {0, 0, 0}, .direction = {0, 0, 1}}, {-1.25, -0.75, 0.75, 1.25});
}

TEST_CASE("a line through the hole crosses nothing, one through the tube both its sides") {
    checkCrossings(kRing, {.origin = {0, 3, 0}, .direction = {0, -1, 0}}, {});
    checkCrossings(kRing, {.origin = {0.74, 3, 0}, .direction = {0, -1, 0}}, {});
    checkCrossings(kRing, {.origin = {1, 3, 0}, .direction = {0, -1, 0}}, {2.75, 3.25});
    checkCrossings(kRing, {.origin = {0, 3, 1.15}, .direction = {0, -1, 0}}, {2.8, 3.2}); // 0.15^2 + 0.2^2 = 0.25^2
}

TEST_CASE("a line along the tube leaves it where the ring bends away") {
    // At distance 1 from the axis the line stays inside as long as 1 + z^2 <= 1.25^2: |z| <= 0.75.
    checkCrossings(kRing, {.origin = {1, 0, 0}, .direction = {0, 0, 1}}, {-0.75, 0.75});
    // At 0.5 the ring's hole is open for 0.25 + z^2 < 0.75^2; outside beyond 0.25 + z^2 = 1.25^2.
    const double inner = std::sqrt(0.3125);
    const double outer = std::sqrt(1.3125);
    checkCrossings(kRing, {.origin = {0.5, 0, 0}, .direction = {0, 0, 1}}, {-outer, -inner, inner, outer});
}

TEST_CASE("a line above the tube misses it, one just below its top crosses a sliver") {
    checkCrossings(kRing, {.origin = {-3, 0.2501, 0}, .direction = {1, 0, 0}}, {});
    // At height h below the top by 1e-8 the tube is 2 sqrt(0.0625 - h^2) = 2 sqrt(0.5e-8 - 1e-16) wide.
    const double reach = std::sqrt(0.5e-8 - 1e-16);
    const double top = 0.25 - 1e-8;
    checkCrossings(kRing, {.origin = {-3, top, 0}, .direction = {1, 0, 0}},
                   {2 - reach, 2 + reach, 4 - reach, 4 + reach}, 1e-11); // 2^-53 / reach = 1.6e-12
}

TEST_CASE("a line that touches the torus from two sides at once passes between them") {
    // The plane through the centre that touches the tube twice has the slope sin a = minor / major (Villarceau). Along
    // its steepest line, as a line at angle b < a, four crossings; at angle c > a, none.
    const double a = std::asin(0.25);
    const auto at = [](double angle) { return dvec3(std::cos(angle), std::sin(angle), 0); };
    CHECK(crossings(WorldTorus(kRing), {.origin = {0, 0, 0}, .direction = at(a - 1e-6)}).size() == 4);
    CHECK(crossings(WorldTorus(kRing), {.origin = {0, 0, 0}, .direction = at(a + 1e-6)}).empty());
}

TEST_CASE("a torus a thousand kilometres away is hit without loss of precision") {
    // Coordinates of 1e6 are rounded by 1e6 * 2^-53 = 1.1e-10, which the slopes of the tube enlarge a few times.
    checkCrossings(kRing, {.origin = {-1e6, 0, 0}, .direction = {1, 0, 0}},
                   {1e6 - 1.25, 1e6 - 0.75, 1e6 + 0.75, 1e6 + 1.25}, 2e-9);
    checkCrossings(kRing, {.origin = {1, 1e6, 0}, .direction = {0, -1, 0}}, {1e6 - 0.25, 1e6 + 0.25}, 2e-9);
}

TEST_CASE("sampling random lines finds the crossings of thick and thin rings, and no others") {
    Random random;
    int crossed = 0;
    for (int i = 0; i < 3000; ++i) {
        const double minor = std::pow(10.0, random.between(-1.5, -0.01));
        Torus torus{.major = 1, .minor = minor, .objectToWorld = glm::dmat4(1)};
        // At the ring: from a random point about it
        const double angle = random.between(0, 6.3);
        const dvec3 target = dvec3(std::cos(angle), 0, std::sin(angle)) + random.inCube(minor);
        const dvec3 way = random.direction();
        const Ray line{.origin = target - 3.0 * way, .direction = way};
        const Crossings list = crossings(WorldTorus(torus), line);
        REQUIRE(list.size() % 2 == 0);
        // A step is short against the tube, so the sign is looked at often enough for all but slivers; where it changes
        // a crossing must be.
        const double step = minor / 50;
        std::size_t passed = 0;
        int wrong = 0;
        for (double t = -2; t < 8; t += step) { // the ring is within 4.5 of the target at t = 3
            const bool before = distanceFrom(torus, line.origin + t * way) <= 0;
            const bool after = distanceFrom(torus, line.origin + (t + step) * way) <= 0;
            std::size_t here = 0;
            for (const Crossing& crossing : list) {
                here += crossing.at.t > t && crossing.at.t <= t + step ? 1 : 0;
            }
            wrong += (before != after) == (here % 2 == 1) ? 0 : 1;
            passed += here;
        }
        CHECK(wrong == 0);
        CHECK(passed == list.size());
        for (const Crossing& crossing : list) {
            CHECK(std::abs(distanceFrom(torus, line.origin + crossing.at.t * way)) < 1e-14);
            ++crossed;
        }
    }
    CHECK(crossed > 5000);
}

TEST_CASE("a torus is where its transform puts it, with the normal of the tube") {
    Random random;
    for (int i = 0; i < 1000; ++i) {
        Torus torus{.major = 1, .minor = 0.25, .objectToWorld = randomMap(random, 10)};
        const double round = random.between(0, 6.3);
        const double about = random.between(0, 6.3);
        const dvec3 outwards(std::cos(round), 0, std::sin(round));
        const dvec3 n = std::cos(about) * outwards + dvec3(0, std::sin(about), 0);
        const dvec3 target(torus.objectToWorld * glm::dvec4(outwards + 0.25 * n, 1));
        const dvec3 expected = glm::normalize(glm::transpose(glm::inverse(glm::dmat3(torus.objectToWorld))) * n);
        const WorldTorus world(torus);
        const Ray ray{.origin = target + 0.5 * expected, .direction = -expected};
        const Crossings list = crossings(world, ray);
        const auto near = std::ranges::find_if(list, [](const Crossing& c) { return std::abs(c.at.t - 0.5) < 1e-11; });
        REQUIRE(near != list.end());
        CHECK(near->entering);
        const SurfacePoint point = surfaceAt(world, ray, near->at);
        checkNear(point.position, target, 1e-11);
        checkNear(point.geometricNormal, expected, 1e-10);
        CHECK(isInside(world, target - 1e-6 * expected));
        CHECK_FALSE(isInside(world, target + 1e-6 * expected));
    }
}
