// Radii from the density of points, on patterns whose density is known.
#include "geometry/search_radius.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace hyalite;
using Catch::Matchers::WithinRel;

namespace {

std::vector<glm::dvec3> scattered(std::size_t count, double side, std::uint32_t seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> coordinate(0, side);
    std::vector<glm::dvec3> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = coordinate(engine);
        points.emplace_back(x, 0, coordinate(engine));
    }
    return points;
}

} // namespace

TEST_CASE("the spacing on a ring is that of the ring, and for two rings that of the one with more points") {
    // The j-th neighbours on either side of a point of a regular n-gon lie 2 R sin(pi j / n) away
    constexpr int kCorners = 360;
    constexpr int kMore = 400;
    std::vector<glm::dvec3> points;
    for (const double radius : {3.0, 0.03}) {
        const int corners = radius == 3 ? kCorners : kMore;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * i / corners;
            points.emplace_back(100 * radius + radius * std::cos(angle), radius * std::sin(angle), 0);
        }
        if (radius == 3) {
            const auto distance = [](int j) { return 6 * std::sin(std::numbers::pi * j / kCorners); };
            CHECK_THAT(typicalSpacing(points, 1), WithinRel(distance(1), 1e-9));
            CHECK_THAT(typicalSpacing(points, 2), WithinRel(distance(1), 1e-9));
            CHECK_THAT(typicalSpacing(points, 3), WithinRel(distance(2), 1e-9));
            CHECK_THAT(typicalSpacing(points, 10), WithinRel(distance(5), 1e-9));
        }
    }
    CHECK_THAT(typicalSpacing(points, 1), WithinRel(0.06 * std::sin(std::numbers::pi / kMore), 1e-9));
}

TEST_CASE("the spacing is that of each point's k-th neighbour among all points") {
    std::vector<glm::dvec3> points = scattered(700, 10, 1);
    for (std::size_t i = 0; i < 200; ++i) { // some in a cluster, some beside a plane
        points.push_back(i % 2 == 0 ? points[i] * 0.01 : points[i] + glm::dvec3(0, 0.1, 0));
    }
    for (const std::size_t k : {1UL, 4UL, 10UL, 60UL}) {
        std::vector<double> spacings;
        for (const glm::dvec3& point : points) {
            std::vector<double> distances;
            for (const glm::dvec3& other : points) {
                distances.push_back(glm::distance(point, other));
            }
            std::ranges::sort(distances); // the first is its own, 0
            spacings.push_back(distances[k]);
        }
        std::ranges::sort(spacings);
        CHECK_THAT(typicalSpacing(points, k), WithinRel(spacings[(points.size() - 1) / 2], 1e-9));
    }
}

TEST_CASE("points that coincide have no distance") {
    CHECK(typicalSpacing(std::vector<glm::dvec3>(50, glm::dvec3(1, 2, 3)), 5) < 1e-100);
}

TEST_CASE("a radius holds the requested number of photons, whatever the pilot pass") {
    // N photons on a square of side 10 have the density N / 100: `wanted` of them in pi r^2 = wanted * 100 / N. The
    // k-th neighbour of a Poisson pattern lies about 1/2 (1 - 1/4k) further in than that, 3 % at k = 10, and the result
    // is rounded to an eighth of an octave, at most 4.5 % off.
    for (const std::uint32_t pilot : {1000U, 8000U}) {
        for (const double wanted : {20.0, 80.0}) {
            const double expected = std::sqrt(wanted * 100 / 200000 / std::numbers::pi);
            const double radius =
                searchRadiusFor(wanted, scattered(pilot, 10, pilot), pilot, 200000, {.sceneRadius = 5});
            CHECK_THAT(radius, WithinRel(expected, 0.1));
            CHECK(std::abs(std::remainder(8 * std::log2(radius), 1)) < 1e-9);
        }
    }
    // Half of the pilot photons landed: half the density
    CHECK_THAT(searchRadiusFor(30, scattered(4000, 10, 7), 8000, 200000, {.sceneRadius = 5}),
               WithinRel(std::sqrt(30 * 100 / 100000.0 / std::numbers::pi), 0.1));
}

TEST_CASE("a radius does not depend on the size of the scene, up to a twentieth of it") {
    const double eighth = std::exp2(1.0 / 16); // rounding moves a bound by no more
    const std::vector<glm::dvec3> spot = scattered(2000, 0.01, 2);
    const double radius = searchRadiusFor(30, spot, 2000, 2000, {.sceneRadius = 1});
    for (const double sceneRadius : {10.0, 1e3, 1e5}) {
        CHECK(searchRadiusFor(30, spot, 2000, 2000, {.sceneRadius = sceneRadius}) == radius);
    }
    CHECK_THAT(searchRadiusFor(30, scattered(2000, 1e6, 3), 2000, 2000, {.sceneRadius = 7}),
               WithinRel(7.0 / 20, eighth - 1));
    // Nor on a quarter of the photons that lie scattered over it
    std::vector<glm::dvec3> more = scattered(600, 1e4, 4);
    more.insert(more.end(), spot.begin(), spot.end());
    CHECK_THAT(searchRadiusFor(30, more, 2600, 2600, {.sceneRadius = 1e5}), WithinRel(radius, 0.3));
}

TEST_CASE("few photons tell a radius too, and where none landed it is a hundredth of the scene") {
    CHECK(searchRadiusFor(30, {}, 8000, 8000, {.sceneRadius = 7}) == 0.07);
    // 20 on a square of side 1: 30 of them in pi r^2 = 30 / 20, were it endless
    CHECK_THAT(searchRadiusFor(30, scattered(20, 1, 1), 8000, 8000, {.sceneRadius = 70}),
               WithinRel(std::sqrt(1.5 / std::numbers::pi), 0.3));
}

TEST_CASE("a disc is no smaller than a pixel, and no smaller than floats resolve") {
    const std::vector<glm::dvec3> focus(100, glm::dvec3(1, 2, 3));
    const double eighth = std::exp2(1.0 / 16);
    CHECK_THAT(searchRadiusFor(12, focus, 100, 100, {.sceneRadius = 9, .eye = {1, 2, 5}, .footprint = 0.001}),
               WithinRel(0.002, eighth - 1));
    CHECK_THAT(searchRadiusFor(12, focus, 100, 100, {.sceneRadius = 9}), WithinRel(3 * 0x1p-18, eighth - 1));
}

TEST_CASE("the largest estimate has four times the radius that holds the photons asked for, less with more photons") {
    // 50 of N photons on a square of side 10 lie in pi r^2 = 5000 / N; rounding and the scatter of ten neighbours as
    // above
    const auto evenly = [](std::uint32_t count) { return 4 * std::sqrt(5000.0 / count / std::numbers::pi); };
    for (const std::uint32_t count : {5000U, 80000U}) {
        const double radius = largestEstimateFor(50, scattered(count, 10, count), 100, {});
        CHECK_THAT(radius, WithinRel(evenly(count), 0.1));
    }
    CHECK(largestEstimateFor(50, scattered(5000, 10, 1), 0.2, {}) == 0.2);
    CHECK(largestEstimateFor(50, {}, 3, {}) == 3);
    // In a focus, four pixels of 0.002
    CHECK_THAT(largestEstimateFor(50, std::vector<glm::dvec3>(500, glm::dvec3(1, 2, 3)), 1,
                                  {.eye = {1, 2, 5}, .footprint = 0.001}),
               WithinRel(0.008, std::exp2(1.0 / 16) - 1));
}
