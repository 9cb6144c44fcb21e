// Quadrics as numbers: values, transforms, centres and bounds, against hand-derived values and random points.
#include "unit/scene/scene_test_support.h"

#include "scene/model/quadric.h"
#include "unit/scene/random_points.h"

#include <algorithm>
#include <array>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace hyalite;
using namespace hyalite::test;
using glm::dmat4;
using glm::dvec3;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

constexpr QuadricForm kEllipsoid{.a = 1, .e = 0.25, .h = 1.0 / 9, .j = -1}; // half-axes 1, 2, 3
constexpr QuadricForm kOneSheet{.a = 1, .e = -1, .h = 1, .j = -1};
constexpr QuadricForm kTwoSheets{.a = 1, .e = -1, .h = 1, .j = 1};
constexpr QuadricForm kParaboloid{.a = 0.25, .g = -0.5, .h = 1}; // x^2/4 + z^2 <= y
constexpr QuadricForm kCone{.a = 1, .e = -1, .h = 1};
constexpr QuadricForm kSaddle{.a = -1, .g = 0.5, .h = 1};
constexpr QuadricForm kTilted{
    .a = 2, .b = 0.5, .c = -0.25, .d = 1, .e = 1, .f = 0.5, .g = -1, .h = 3, .i = 0.5, .j = -2};
constexpr std::array kForms{kEllipsoid, kOneSheet, kTwoSheets, kParaboloid, kCone, kSaddle, kTilted};

// Turned, stretched differently along each axis, sheared and moved.
dmat4 crookedMap() {
    dmat4 shear(1);
    shear[1][0] = 0.4;
    shear[0][2] = -0.3;
    const dmat4 stretched = glm::scale(shear, dvec3(0.5, 2, -1.5));
    return glm::translate(dmat4(1), dvec3(3, -4, 5)) * glm::rotate(dmat4(1), 1.1, dvec3(1, 2, -3)) * stretched;
}

dvec3 image(const dmat4& map, const dvec3& point) {
    return map * glm::dvec4(point, 1);
}

void checkNear(const dvec3& actual, const dvec3& expected, double tolerance = 1e-12) {
    INFO("(" << actual.x << ", " << actual.y << ", " << actual.z << ") against (" << expected.x << ", " << expected.y
             << ", " << expected.z << ")");
    CHECK(glm::length(actual - expected) <= tolerance);
}

void checkBounds(const Bounds& actual, const Bounds& expected) {
    for (int axis = 0; axis < 3; ++axis) {
        INFO("axis " << axis);
        if (std::isinf(expected.low[axis])) {
            CHECK(actual.low[axis] == expected.low[axis]);
        } else {
            CHECK_THAT(actual.low[axis], WithinAbs(expected.low[axis], 1e-12));
        }
        if (std::isinf(expected.high[axis])) {
            CHECK(actual.high[axis] == expected.high[axis]);
        } else {
            CHECK_THAT(actual.high[axis], WithinAbs(expected.high[axis], 1e-12));
        }
    }
}

bool contains(const Bounds& box, const dvec3& point, double slack = 0) {
    return glm::all(glm::greaterThanEqual(point, box.low - slack)) &&
           glm::all(glm::lessThanEqual(point, box.high + slack));
}

} // namespace

TEST_CASE("a form's value and gradient are those of its formula") {
    const QuadricForm form{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    // At (1, 2, 3): 1 + 2*2*2 + 2*3*3 + 2*4 + 5*4 + 2*6*6 + 2*7*2 + 8*9 + 2*9*3 + 10.
    CHECK(evaluate(form, {1, 2, 3}) == 291);
    // (x + 2y + 3z + 4, 2x + 5y + 6z + 7, 3x + 6y + 8z + 9)
    CHECK(halfGradient(form, {1, 2, 3}) == dvec3(18, 37, 48));
}

TEST_CASE("a form's matrix gives its value and comes back as the same form") {
    const QuadricForm form{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    const glm::dvec4 p(1, 2, 3, 1);
    CHECK(glm::dot(p, quadricMatrix(form) * p) == 291);
    const QuadricForm back = quadricForm(quadricMatrix(form));
    CHECK(std::array{back.a, back.b, back.c, back.d, back.e, back.f, back.g, back.h, back.i, back.j} ==
          std::array{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0});
}

TEST_CASE("a form is divided by the magnitude of its largest coefficient") {
    const QuadricForm form = normalised({.a = 1, .c = -4, .j = 2});
    CHECK(form.a == 0.25);
    CHECK(form.c == -1);
    CHECK(form.j == 0.5);
}

TEST_CASE("a transformed form is 0 on the image of the surface") {
    // The unit sphere stretched to twice its width and moved by 1 along x: (x - 1)^2 / 4 + y^2 + z^2 - 1.
    const QuadricForm sphere{.a = 1, .e = 1, .h = 1, .j = -1};
    const QuadricForm moved =
        transformed(sphere, glm::translate(dmat4(1), dvec3(1, 0, 0)) * glm::scale(dmat4(1), dvec3(2, 1, 1)));
    CHECK(moved.a == 0.25);
    CHECK(moved.d == -0.25);
    CHECK(moved.e == 1);
    CHECK(moved.h == 1);
    CHECK(moved.j == -0.75);
    CHECK(std::array{moved.b, moved.c, moved.f, moved.g, moved.i} == std::array{0.0, 0.0, 0.0, 0.0, 0.0});

    // Anywhere, the new form at the image of a point has the old one's value at the point.
    RandomPoints random(1);
    const dmat4 map = crookedMap();
    for (const QuadricForm& form : kForms) {
        const QuadricForm there = transformed(form, map);
        for (int i = 0; i < 1000; ++i) {
            const dvec3 point = random.inCube(3);
            // Terms of up to a few hundred (coefficients up to 10, coordinates up to 12) err by 1e-14 of that or so.
            CHECK_THAT(evaluate(there, image(map, point)), WithinAbs(evaluate(form, point), 1e-10));
        }
    }
}

TEST_CASE("the bounds of an ellipsoid touch it") {
    checkBounds(formBounds(kEllipsoid), {{-1, -2, -3}, {1, 2, 3}});
    // Turned by 45 degrees about z it reaches sqrt((1^2 + 2^2) / 2) along x and y.
    const dmat4 map = glm::rotate(glm::translate(dmat4(1), dvec3(10, 20, 30)), std::numbers::pi / 4, dvec3(0, 0, 1));
    const double reach = std::sqrt(2.5);
    checkBounds(worldBounds({.form = kEllipsoid, .objectToWorld = map}),
                {{10 - reach, 20 - reach, 27}, {10 + reach, 20 + reach, 33}});
}

TEST_CASE("a small ellipsoid far away has bounds as narrow as near") {
    // Its form in world coordinates would be a difference of numbers of 1e18 times what is left of them.
    const QuadricForm tiny{.a = 1e6, .e = 1e6, .h = 1e6, .j = -1};
    const dmat4 map = glm::rotate(glm::translate(dmat4(1), dvec3(1e6, 0, 0)), 0.5, dvec3(0, 0, 1));
    const Bounds box = worldBounds({.form = tiny, .objectToWorld = map});
    CHECK_THAT(box.low.x - 1e6, WithinAbs(-0.001, 1e-9)); // 1e6 itself is a multiple of 1.2e-10 in a double
    CHECK_THAT(box.high.x - 1e6, WithinAbs(0.001, 1e-9));
    CHECK_THAT(box.high.y, WithinAbs(0.001, 1e-9));
}

TEST_CASE("a cylinder is unbounded along its axis, and bounded across it") {
    const QuadricForm cylinder{.a = 0.25, .h = 1, .j = -1};
    checkBounds(formBounds(cylinder), {{-2, -kInfinite, -1}, {2, kInfinite, 1}});
    // Turned, nothing about its form tells where it ends but rounding: it must not be taken for an ellipsoid.
    for (const double angle : {0.1, 0.7, 1.3, 2.9}) {
        const QuadricForm turned = transformed(cylinder, glm::rotate(dmat4(1), angle, dvec3(1, 2, 3)));
        checkBounds(formBounds(turned), Bounds::everything());
    }
}

TEST_CASE("shapes clipped along one axis are bounded along the others by their sections") {
    const auto bounds = [](const QuadricForm& form, double low, double high) {
        Quadric quadric{.form = form, .clip = Bounds::everything()};
        quadric.clip.low.y = low;
        quadric.clip.high.y = high;
        return objectBounds(quadric);
    };
    // At y the radius is sqrt(1 + y^2), |y|, and sqrt(y^2 - 1) from y = 1 on; at -1 <= y <= 2 these are at most:
    const double r = std::sqrt(5);
    checkBounds(bounds(kOneSheet, -1, 2), {{-r, -1, -r}, {r, 2, r}});
    checkBounds(bounds(kCone, -1, 2), {{-2, -1, -2}, {2, 2, 2}});
    const double s = std::sqrt(3);
    checkBounds(bounds(kTwoSheets, 0, 2), {{-s, 1, -s}, {s, 2, s}});
    // x^2/4 + z^2 <= y begins at its vertex, box or no box, and has half-axes 2 sqrt(y) and sqrt(y).
    checkBounds(bounds(kParaboloid, -kInfinite, 4), {{-4, 0, -2}, {4, 4, 2}});
    checkBounds(bounds(kParaboloid, -7, kInfinite), {{-kInfinite, 0, -kInfinite}, {kInfinite, kInfinite, kInfinite}});
    CHECK(isEmpty(bounds(kTwoSheets, -0.5, 0.5)));
    CHECK(isEmpty(bounds(kParaboloid, -2, -1)));
    // A saddle has hyperbolas for sections, which do not end.
    CHECK_FALSE(std::isfinite(bounds(kSaddle, -1, 1).high.x));
}

TEST_CASE("bounds hold every point of the shape, in object space and in the world") {
    RandomPoints random(2);
    const dmat4 map = crookedMap();
    for (const QuadricForm& form : kForms) {
        for (int box = 0; box < 50; ++box) {
            // Some sides are missing.
            Quadric quadric{.form = form, .clip = Bounds::everything(), .objectToWorld = map};
            const dvec3 one = random.inCube(3);
            const dvec3 other = random.inCube(3);
            for (int axis = 0; axis < 3; ++axis) {
                if (random.unit() < 0.7) {
                    quadric.clip.low[axis] = std::min(one[axis], other[axis]);
                }
                if (random.unit() < 0.7) {
                    quadric.clip.high[axis] = std::max(one[axis], other[axis]);
                }
            }
            const Bounds object = objectBounds(quadric);
            const Bounds world = worldBounds(quadric);
            const Bounds clip = withFiniteClip(quadric).clip;
            for (int i = 0; i < 200; ++i) {
                const dvec3 point = random.inCube(4);
                if (evaluate(form, point) <= 0 && contains(quadric.clip, point)) {
                    REQUIRE(contains(object, point));
                    REQUIRE(contains(clip, point));
                    REQUIRE(contains(world, image(map, point), 1e-12)); // the image is rounded
                }
            }
        }
    }
}

TEST_CASE("missing sides of a clip box are put a little outside of the shape") {
    Quadric cone{.form = kCone, .clip = Bounds::everything()};
    cone.clip.low.y = -2;
    cone.clip.high.y = 1;
    const Bounds clip = withFiniteClip(cone).clip;
    CHECK(clip.low.y == -2);
    CHECK(clip.high.y == 1);
    for (const double side : {-clip.low.x, clip.high.x, -clip.low.z, clip.high.z}) {
        CHECK(side > 2);
        CHECK(side < 2.05);
    }
    // Without any side there is nothing to cut, and the surface stays closed.
    checkBounds(withFiniteClip({.form = kEllipsoid}).clip, Bounds::everything());
}

TEST_CASE("a form's centre is its best-conditioned origin") {
    const auto moved = [](const QuadricForm& form, const dvec3& by) {
        return transformed(form, glm::rotate(glm::translate(dmat4(1), by), 1.0, dvec3(1, 1, 0)));
    };
    const dvec3 there(7, -8, 9);
    // Ellipsoids, hyperboloids and cones are about their centres already, paraboloids about their vertices.
    for (const QuadricForm& form : {kEllipsoid, kOneSheet, kTwoSheets, kCone, kParaboloid, kSaddle}) {
        checkNear(formCenter(moved(form, there)), there, 1e-9); // far off by 1e2, squared and back, at 1e-15
    }
    // Of the axis of a cylinder, the nearest point to the origin: (3, 4, 0) for the z axis moved there.
    checkNear(formCenter({.a = 1, .d = -3, .e = 1, .g = -4, .j = 24}), {3, 4, 0});
    // Of the planes x = 1 and x = 5, the middle; of the plane 2y = 6 it is (0, 3, 0).
    checkNear(formCenter({.a = 1, .d = -3, .j = 5}), {3, 0, 0});
    checkNear(formCenter({.g = 1, .j = -6}), {0, 3, 0});
}

TEST_CASE("the extremes of a form within a box are attained within it") {
    const QuadricForm sphere{.a = 1, .e = 1, .h = 1, .j = -1};
    // Nearest to the origin in [1, 2] x [-1, 1]^2 is (1, 0, 0), on a face; farthest a corner: 4 + 1 + 1 - 1.
    const Extremes face = extremes(sphere, {{1, -1, -1}, {2, 1, 1}});
    CHECK(face.least == 0);
    CHECK(face.greatest == 5);
    // Around the centre it is -1; y - x^2 + z^2 goes from y = -1, x = 3, z = 0 to y = 2, x = 0, z = -4.
    CHECK(extremes(sphere, {dvec3(-2), dvec3(3)}).least == -1);
    const Extremes saddle = extremes(kSaddle, {{-2, -1, -4}, {3, 2, 1}});
    CHECK(saddle.least == -10);
    CHECK(saddle.greatest == 18);

    // No point of a grid goes beyond them, and one comes as near as the steepest slope times half a cell allows.
    RandomPoints random(3);
    constexpr int kCells = 8;
    for (const QuadricForm& form : kForms) {
        for (int box = 0; box < 50; ++box) {
            Bounds bounds;
            bounds.add(random.inCube(3));
            bounds.add(random.inCube(3));
            const dvec3 cell = (bounds.high - bounds.low) / static_cast<double>(kCells);
            Extremes grid{kInfinite, -kInfinite};
            double steepest = 0; // |gradient|, which is convex, is greatest at a corner
            for (int i = 0; i < (kCells + 1) * (kCells + 1) * (kCells + 1); ++i) {
                const dvec3 steps(i % (kCells + 1), i / (kCells + 1) % (kCells + 1), i / (kCells + 1) / (kCells + 1));
                const dvec3 point = bounds.low + steps * cell;
                const double q = evaluate(form, point);
                grid = {std::min(grid.least, q), std::max(grid.greatest, q)};
                steepest = std::max(steepest, 2 * glm::length(halfGradient(form, point)));
            }
            const Extremes q = extremes(form, bounds);
            const double gap = steepest * glm::length(cell) / 2;
            CHECK(q.least <= grid.least + 1e-12); // the same corner, reached with other roundings
            CHECK(q.least >= grid.least - gap);
            CHECK(q.greatest >= grid.greatest - 1e-12);
            CHECK(q.greatest <= grid.greatest + gap);
        }
    }
}

TEST_CASE("the eigenvectors of a symmetric matrix turn it into its diagonal") {
    // Eigenvalues 1 (of (1, -1, 0)), 3 (of (1, 1, 0)) and 5.
    const glm::dmat3 matrix(2, 1, 0, 1, 2, 0, 0, 0, 5);
    const Eigensystem e = eigensystem(matrix);
    dvec3 sorted = e.values;
    std::sort(&sorted.x, &sorted.x + 3);
    checkNear(sorted, {1, 3, 5});
    for (int i = 0; i < 3; ++i) {
        checkNear(matrix * e.vectors[i], e.values[i] * e.vectors[i]);
        CHECK_THAT(glm::length(e.vectors[i]), WithinRel(1.0, 1e-14));
    }
}

TEST_CASE("a plane's half-space is behind it") {
    const Quadric solid = halfSpace({.point = {1, 2, 3}, .normal = {0, 0.6, 0.8}});
    // In front by 5 along the normal, behind by 5.
    CHECK_THAT(evaluate(solid.form, {1, 5, 7}), WithinRel(5.0, 1e-14));
    CHECK_THAT(evaluate(solid.form, {1, -1, -1}), WithinRel(-5.0, 1e-14));
}
