// Bounding spheres hold all points and are at most 20 % larger than the least one: known analytically for regular sets,
// found by Welzl's algorithm for the others.
#include "geometry/bounding_sphere.h"

#include "scene/import/teapot.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using Catch::Matchers::WithinRel;
using namespace hyalite;
using glm::dvec3;
using glm::vec3;

namespace {

using Points = std::vector<vec3>;

// Welzl's least sphere [Welzl91], moving points that were found outside to the front.
class LeastSphere {
public:
    explicit LeastSphere(Points points) : points_(std::move(points)) {
        std::shuffle(points_.begin(), points_.end(), std::mt19937(1));
    }
    double radius() {
        grow(points_.size(), {});
        return sphere_.radius;
    }

private:
    // The smallest sphere with all these points on it: its centre is a + x where 2 x . (b - a) = |b - a|^2 for each
    // other point b, x in the span of the b - a.
    static BoundingSphere through(const std::vector<dvec3>& on) {
        if (on.empty()) {
            return {};
        }
        const dvec3 a = on[0];
        dvec3 x(0);
        if (on.size() == 2) {
            x = 0.5 * (on[1] - a);
        } else if (on.size() == 3) {
            const dvec3 b = on[1] - a;
            const dvec3 c = on[2] - a;
            const dvec3 n = glm::cross(b, c);
            x = (glm::dot(b, b) * glm::cross(c, n) + glm::dot(c, c) * glm::cross(n, b)) / (2 * glm::dot(n, n));
        } else if (on.size() == 4) {
            const dvec3 b = on[1] - a;
            const dvec3 c = on[2] - a;
            const dvec3 d = on[3] - a;
            x = (glm::dot(b, b) * glm::cross(c, d) + glm::dot(c, c) * glm::cross(d, b) +
                 glm::dot(d, d) * glm::cross(b, c)) /
                (2 * glm::dot(b, glm::cross(c, d)));
        }
        return {a + x, glm::length(x)};
    }

    void grow(std::size_t count, const std::vector<dvec3>& on) {
        sphere_ = through(on);
        if (on.size() == 4) {
            return;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const dvec3 point = points_[i];
            if (glm::distance(point, sphere_.center) > sphere_.radius * (1 + 1e-12)) {
                std::vector<dvec3> more = on;
                more.push_back(point);
                grow(i, more);
                const auto at = points_.begin() + static_cast<std::ptrdiff_t>(i);
                std::rotate(points_.begin(), at, at + 1);
            }
        }
    }

    Points points_;
    BoundingSphere sphere_;
};

void checkBetween(const Points& points, double least) {
    const BoundingSphere sphere = boundingSphere(points);
    for (const vec3& point : points) {
        REQUIRE(glm::distance(dvec3(point), sphere.center) <= sphere.radius);
    }
    CHECK(sphere.radius <= 1.2 * least);
    CHECK(sphere.radius >= least * (1 - 1e-6)); // less is impossible, but for the rounding of points to floats
}

Points randomPoints(std::size_t count, unsigned seed, const vec3& stretch, bool onSphere) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> coordinate(-1, 1);
    Points points;
    while (points.size() < count) {
        vec3 point(coordinate(engine), coordinate(engine), coordinate(engine));
        const float length = glm::length(point);
        if (onSphere && (length > 1 || length < 0.1F)) {
            continue;
        }
        points.push_back((onSphere ? point / length : point) * stretch);
    }
    return points;
}

} // namespace

TEST_CASE("Welzl's algorithm finds analytically known spheres") {
    // Of a box, half its diagonal; of a thin triangle, half its longest side.
    CHECK_THAT(LeastSphere({{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {2, 3, 6}, {2, 0, 6}}).radius(), WithinRel(3.5, 1e-12));
    CHECK_THAT(LeastSphere({{0, 0, 0}, {10, 0, 0}, {4, 1, 0}}).radius(), WithinRel(5.0, 1e-12));
}

TEST_CASE("the bounding sphere of no points is empty, and of one point that point") {
    CHECK(boundingSphere({}).radius < 0);
    const BoundingSphere sphere = boundingSphere(Points{{1, 2, 3}, {1, 2, 3}});
    CHECK(sphere.radius == 0);
    CHECK(sphere.center == dvec3(1, 2, 3));
}

TEST_CASE("bounding spheres of regular sets are at most 20 % too large") {
    Points cube;
    for (int corner = 0; corner < 8; ++corner) {
        cube.emplace_back(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    }
    checkBetween(cube, std::sqrt(3.0) / 2);

    // Regular simplex from corners of a cube, about its centre: their distance from it.
    checkBetween({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, std::sqrt(3.0));

    checkBetween({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, 1);

    // An equilateral triangle, whose longest side is far from a diameter: side / sqrt(3).
    checkBetween({{0, 0, 0}, {2, 0, 0}, {1, std::sqrt(3.0F), 0}}, 2 / std::sqrt(3.0));

    Points line;
    for (int i = 0; i <= 1000; ++i) {
        line.emplace_back(vec3(1, 2, -2) * static_cast<float>(i)); // ends 3000 apart
    }
    checkBetween(line, 1500);
}

TEST_CASE("bounding spheres of random sets are at most 20 % larger than Welzl's") {
    for (unsigned seed = 0; seed < 100; ++seed) {
        INFO("seed " << seed);
        const std::size_t count = 4 + seed * 5;
        for (const vec3& stretch : {vec3(1), vec3(1, 0.1F, 3), vec3(1e-6F, 1, 1), vec3(1e6F)}) {
            for (const bool onSphere : {false, true}) {
                const Points points = randomPoints(count, seed, stretch, onSphere);
                checkBetween(points, LeastSphere(points).radius());
            }
        }
    }
}

TEST_CASE("a cluster of points on one side does not pull the bounding sphere away") {
    Points points = randomPoints(5000, 1, vec3(1e-3F), false);
    points.emplace_back(10, 0, 0);
    points.emplace_back(5, 8, 1);
    checkBetween(points, LeastSphere(points).radius());
}

TEST_CASE("the bounding sphere of the teapot is at most 20 % too large, and the same on every run") {
    const Mesh mesh = makeTeapot(20);
    checkBetween(mesh.positions, LeastSphere(mesh.positions).radius());
    const BoundingSphere once = boundingSphere(mesh.positions);
    const BoundingSphere again = boundingSphere(mesh.positions);
    CHECK(once.center == again.center);
    CHECK(once.radius == again.radius);
}
