// Lines against quadrics: crossings derived on paper, lines that make the quadratic linear, and the two ways of
// transforming a surface.
#include "reference/shapes/solid.h"

#include "unit/reference/random_solids.h"

#include <cmath>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

Quadric plain(const QuadricForm& form) {
    return {.form = form, .clip = Bounds::everything(), .capped = true, .objectToWorld = glm::dmat4(1)};
}

Quadric cappedCylinder() {
    return {.form = diagonalForm(1, 0, 1, -1),
            .clip = {{-kEndless, -2, -kEndless}, {kEndless, 3, kEndless}},
            .capped = true,
            .objectToWorld = glm::dmat4(1)};
}

struct Expected {
    double t = 0;
    std::uint32_t part = 0;
    bool entering = false;
};

void checkCrossings(const Quadric& quadric, const Ray& line, const std::vector<Expected>& expected,
                    double tolerance = 1e-14) {
    const Crossings actual = crossings(WorldQuadric(quadric), line);
    REQUIRE(actual.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CAPTURE(i);
        if (std::isinf(expected[i].t)) {
            CHECK(actual[i].at.t == expected[i].t);
        } else {
            CHECK_THAT(actual[i].at.t, WithinAbs(expected[i].t, tolerance));
            CHECK(actual[i].at.part == expected[i].part);
        }
        CHECK(actual[i].entering == expected[i].entering);
    }
}

// In extended precision, and by transforming the ray instead of the form.
struct ByRay {
    std::vector<double> roots; // of q(o' + t d'), within the clip box
    double slope = 0;          // of q along the ray, at either root
    bool doubtful = false;     // touches q, or passes an edge of the clip box
};
ByRay rootsByRay(const Quadric& quadric, const Ray& ray) {
    using Vec = glm::vec<3, long double>;
    const auto inverse = glm::inverse(glm::mat<4, 4, long double>(quadric.objectToWorld));
    const Vec o(inverse * glm::vec<4, long double>(Vec(ray.origin), 1));
    const Vec d(inverse * glm::vec<4, long double>(Vec(ray.direction), 0));
    const QuadricForm& q = quadric.form;
    const auto A = [&](const Vec& p) {
        return Vec(q.a * p.x + q.b * p.y + q.c * p.z, q.b * p.x + q.e * p.y + q.f * p.z,
                   q.c * p.x + q.f * p.y + q.h * p.z);
    };
    const Vec b(q.d, q.g, q.i);
    const long double alpha = glm::dot(d, A(d));
    const long double beta = glm::dot(d, A(o) + b);
    const long double gamma = glm::dot(o, A(o)) + 2 * glm::dot(b, o) + q.j;
    const long double discriminant = beta * beta - alpha * gamma;
    ByRay result{.roots = {}, .slope = 0, .doubtful = std::abs(discriminant) < 1e-8L};
    if (discriminant < 0) {
        return result;
    }
    const long double root = std::sqrt(discriminant);
    result.slope = static_cast<double>(2 * root);
    for (const long double t :
         {(-beta - std::copysign(root, alpha)) / alpha, (-beta + std::copysign(root, alpha)) / alpha}) {
        const Vec p = glm::abs(o + t * d);
        const long double farthest = std::max({p.x, p.y, p.z});
        result.doubtful = result.doubtful || std::abs(farthest - 1) < 1e-6L;
        if (farthest < 1) {
            result.roots.push_back(static_cast<double>(t));
        }
    }
    return result;
}

double valueOf(const QuadricForm& q, const dvec3& p) {
    return q.a * p.x * p.x + q.e * p.y * p.y + q.h * p.z * p.z +
           2 * (q.b * p.x * p.y + q.c * p.x * p.z + q.f * p.y * p.z + q.d * p.x + q.g * p.y + q.i * p.z) + q.j;
}

} // namespace

TEST_CASE("a line along an axis crosses an ellipsoid at its semi-axes") {
    // x^2 / 4 + y^2 + 4 z^2 = 1
    const Quadric ellipsoid = plain(diagonalForm(0.25, 1, 4, -1));
    checkCrossings(ellipsoid, {.origin = {-5, 0, 0}, .direction = {1, 0, 0}}, {{3, 0, true}, {7, 0, false}});
    checkCrossings(ellipsoid, {.origin = {0, 5, 0}, .direction = {0, -1, 0}}, {{4, 0, true}, {6, 0, false}});
    checkCrossings(ellipsoid, {.origin = {0, 0, 0}, .direction = {0, 0, 1}}, {{-0.5, 0, true}, {0.5, 0, false}});
    checkCrossings(ellipsoid, {.origin = {0, 1.001, 0}, .direction = {1, 0, 0}}, {});
    checkCrossings(ellipsoid, {.origin = {0, 1, 0}, .direction = {1, 0, 0}}, {{0, 0, true}, {0, 0, false}}); // touches
}

TEST_CASE("a line parallel to an endless cylinder is inside all along or nowhere") {
    const Quadric cylinder = endlessCylinder(1, 1);
    checkCrossings(cylinder, {.origin = {0.5, 7, 0}, .direction = {0, 1, 0}},
                   {{-kEndless, 0, true}, {kEndless, 0, false}});
    checkCrossings(cylinder, {.origin = {1.5, 7, 0}, .direction = {0, 1, 0}}, {});
    // Slope 1 against the axis: x from -1 to 1 takes sqrt 2 each way.
    const double root2 = std::sqrt(2.0);
    checkCrossings(cylinder, {.origin = {0, 0, 0}, .direction = {1 / root2, 1 / root2, 0}},
                   {{-root2, 0, true}, {root2, 0, false}});
}

TEST_CASE("a line along which q is linear has one crossing") {
    // The paraboloid y = x^2 + z^2 from above at x = 0.5: y = 0.25 is 4.75 below y = 5; inside lies above.
    QuadricForm bowl = diagonalForm(1, 0, 1, 0);
    bowl.g = -0.5;
    checkCrossings(plain(bowl), {.origin = {0.5, 5, 0}, .direction = {0, -1, 0}},
                   {{-kEndless, 0, true}, {4.75, 0, false}});
    // The cone x^2 + z^2 = y^2 along a generator's direction from (1, 0, 0): (1 + s)^2 - s^2 = 0 at s = -1/2, and
    // s = t / sqrt 2.
    const double half = std::sqrt(0.5);
    checkCrossings(plain(diagonalForm(1, -1, 1, 0)), {.origin = {1, 0, 0}, .direction = {half, half, 0}},
                   {{-kEndless, 0, true}, {-half, 0, false}});
    // A plane, as the form 2y: q = 0 at y = 0.
    checkCrossings(plain({.g = 1}), {.origin = {3, 2, 1}, .direction = {0, -1, 0}},
                   {{2, 0, true}, {kEndless, 0, false}});
    checkCrossings(plain({.g = 1}), {.origin = {3, 2, 1}, .direction = {1, 0, 0}}, {});
}

TEST_CASE("a line that starts beside the linear case keeps the near crossing") {
    // The bowl again, from (1/2, 5, 0), steeply down with dx = -1e-9: x stays 1/2 to 5e-9, so y = 1/4 to 5e-9 too; the
    // other root is where x has gone down by about 1e9.
    QuadricForm bowl = diagonalForm(1, 0, 1, 0);
    bowl.g = -0.5;
    const Crossings list =
        crossings(WorldQuadric(plain(bowl)), {.origin = {0.5, 5, 0}, .direction = glm::normalize(dvec3(-1e-9, -1, 0))});
    REQUIRE(list.size() == 2);
    CHECK_THAT(list[0].at.t, WithinRel(-1e18, 1e-6));
    // 5 - s = (0.5 - 1e-9 s)^2 = 0.25 - 1e-9 s + ...: s (1 - 1e-9) = 4.75
    CHECK_THAT(list[1].at.t, WithinAbs(4.75 + 4.75e-9, 1e-13));
}

TEST_CASE("a line through a hyperboloid of two sheets is inside at both its ends") {
    // x^2 + z^2 - y^2 + 1 <= 0 where |y| >= 1 on the axis
    checkCrossings(plain(diagonalForm(1, -1, 1, 1)), {.origin = {0, -3, 0}, .direction = {0, 1, 0}},
                   {{-kEndless, 0, true}, {2, 0, false}, {4, 0, true}, {kEndless, 0, false}});
}

TEST_CASE("the faces of a box are parts 1 to 6") {
    const Quadric box = axisBox({-1, -2, -3}, {4, 5, 6});
    const dvec3 middle = {0.5, 1, 1.5};
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 direction(0);
        direction[axis] = 1;
        const double toLow = middle[axis] - box.clip.low[axis];
        const double toHigh = box.clip.high[axis] - middle[axis];
        const auto low = static_cast<std::uint32_t>(1 + 2 * axis);
        checkCrossings(box, {.origin = middle, .direction = direction},
                       {{-toLow, low, true}, {toHigh, low + 1, false}});
        checkCrossings(box, {.origin = middle, .direction = -direction},
                       {{-toHigh, low + 1, true}, {toLow, low, false}});
        const Ray beside{.origin = middle + dvec3(100) - 100.0 * direction, .direction = direction};
        checkCrossings(box, beside, {});
        for (const bool high : {false, true}) {
            const WorldQuadric world(box);
            const SurfacePoint point = surfaceAt(world, {.origin = middle, .direction = direction},
                                                 {.t = high ? toHigh : -toLow, .part = high ? low + 1 : low});
            checkNear(point.geometricNormal, high ? direction : -direction, 1e-15);
            CHECK_THAT(point.position[axis], WithinAbs(high ? box.clip.high[axis] : box.clip.low[axis], 1e-14));
        }
    }
}

TEST_CASE("a capped cylinder is left through its side or its caps") {
    const double half = std::sqrt(0.5);
    checkCrossings(cappedCylinder(), {.origin = {0.5, 10, 0}, .direction = {0, -1, 0}}, {{7, 4, true}, {12, 3, false}});
    // From (-3, 0, 0) upwards at 45 degrees: the side at x = -1 after 2 in x, then y = 2 at x = -1; y = 3 at x = 0.
    checkCrossings(cappedCylinder(), {.origin = {-3, 0, 0}, .direction = {half, half, 0}},
                   {{2 / half, 0, true}, {3 / half, 4, false}});
    checkCrossings(cappedCylinder(), {.origin = {-3, 3.001, 0}, .direction = {1, 0, 0}}, {});
}

TEST_CASE("without caps the clip box cuts the surface and closes nothing") {
    Quadric tube = cappedCylinder();
    tube.capped = false;
    checkCrossings(tube, {.origin = {0.5, 10, 0}, .direction = {0, -1, 0}}, {});
    checkCrossings(tube, {.origin = {-3, 0, 0}, .direction = {1, 0, 0}}, {{2, 0, true}, {4, 0, false}});
    // Down through the open top and out of the side: from (0, 4, 0), x = 1 at y = 3 - which is the rim - or later.
    const dvec3 down = glm::normalize(dvec3(1, -2, 0));
    checkCrossings(tube, {.origin = {0, 4, 0}, .direction = down}, {{std::sqrt(5.0), 0, false}});
    CHECK_FALSE(isInside(WorldQuadric(tube), {0, 0, 0}));
    CHECK(isInside(WorldQuadric(cappedCylinder()), {0, 0, 0}));
    CHECK_FALSE(isInside(WorldQuadric(cappedCylinder()), {0, 4, 0}));
    CHECK_FALSE(isInside(WorldQuadric(cappedCylinder()), {0.8, 0, 0.8}));
}

TEST_CASE("a quadric a thousand kilometres away is hit without loss of precision") {
    // Coordinates of 1e6 are rounded by 1e6 * 2^-53 = 1.1e-10; the plain quadratic would lose 1e12 * 2^-53 = 1e-4.
    // Height 0.6 on the unit sphere about the target: the chord is 1.6 long.
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const dvec3 way = random.direction();
        const dvec3 across = orthonormalBasis(way).tangent;
        const Quadric ball = plain(diagonalForm(1, 1, 1, -1));
        checkCrossings(ball, {.origin = -1e6 * way + 0.6 * across, .direction = way},
                       {{1e6 - 0.8, 0, true}, {1e6 + 0.8, 0, false}}, 2e-9);
    }
}

TEST_CASE("transforming the form and transforming the ray give the same hits") {
    // Rounded coordinates are off by some 2^-53 of the place and the ray's way (20 at most), twice that in object space
    // where the shape may be shrunk to half; times the gradient, at most 25 in the box, and with the terms of q, at
    // most 50, that is the rounding of q; over its slope, that of t. 16 roundings of each kind.
    Random random;
    int met = 0;
    for (int i = 0; i < 30000; ++i) {
        const double place = i % 2 == 0 ? 1 : 1000;
        Quadric quadric = randomQuadric(random, place);
        quadric.capped = false;
        const dvec3 at(quadric.objectToWorld[3]);
        const dvec3 way = random.direction();
        const Ray ray{.origin = at + random.inCube(0.5) - way * random.between(0, 20), .direction = way};
        const ByRay expected = rootsByRay(quadric, ray);
        if (expected.doubtful) {
            continue;
        }
        const double rounding = 16 * 0x1p-53 * (25 * 2 * (std::sqrt(3.0) * place + 20) + 50);
        const Crossings actual = crossings(WorldQuadric(quadric), ray);
        REQUIRE(actual.size() == expected.roots.size());
        for (std::size_t k = 0; k < actual.size(); ++k) {
            CHECK_THAT(actual[k].at.t, WithinAbs(expected.roots[k], rounding / expected.slope));
            ++met;
        }
    }
    CHECK(met > 10000);
}

TEST_CASE("q changes sign at every crossing of its surface, in the direction of the crossing") {
    Random random;
    int crossed = 0;
    for (int i = 0; i < 20000; ++i) {
        const Quadric quadric = randomQuadric(random, 10);
        const WorldQuadric world(quadric);
        const glm::dmat4 toObject = glm::inverse(quadric.objectToWorld);
        const dvec3 at(quadric.objectToWorld[3]);
        const Ray ray{.origin = at + random.inCube(1), .direction = random.direction()};
        const auto valueAt = [&](double t) {
            return valueOf(quadric.form, dvec3(toObject * glm::dvec4(ray.origin + t * ray.direction, 1)));
        };
        for (const Crossing& crossing : crossingsOf(Solid(world), ray)) {
            if (crossing.at.part != 0) {
                continue;
            }
            // q is a parabola along the ray. Its slope 2e at the root outweighs its curvature, at most 12, and
            // rounding, where the step is a hundredth of that slope.
            const double slope = (valueAt(crossing.at.t + 1e-4) - valueAt(crossing.at.t - 1e-4)) / 2e-4;
            const double step = std::abs(slope) / 100;
            if (step < 1e-5) {
                continue; // touches
            }
            CHECK((valueAt(crossing.at.t - step) > 0) == crossing.entering);
            CHECK((valueAt(crossing.at.t + step) <= 0) == crossing.entering);
            ++crossed;
        }
    }
    CHECK(crossed > 5000);
}

TEST_CASE("the normal of an ellipsoid is that of its equation, transformed by the inverse transpose") {
    // The unit sphere under a map M: normal at M p is M^-T p.
    Random random;
    for (int i = 0; i < 1000; ++i) {
        Quadric ball = plain(diagonalForm(1, 1, 1, -1));
        ball.objectToWorld = randomMap(random, 10);
        const dvec3 p = random.direction();
        const dvec3 target(ball.objectToWorld * glm::dvec4(p, 1));
        const dvec3 expected = glm::normalize(glm::transpose(glm::inverse(glm::dmat3(ball.objectToWorld))) * p);
        const Ray ray{.origin = target + 2.0 * expected, .direction = -expected};
        const SurfacePoint point = surfaceAt(WorldQuadric(ball), ray, {.t = 2});
        checkNear(point.geometricNormal, expected, 1e-12);
        checkNear(point.position, target, 1e-13);
        CHECK(point.offset < 1e-12);
    }
}

TEST_CASE("at the apex of a cone the surface faces the ray, and the offset stays small") {
    const WorldQuadric cone(plain(diagonalForm(1, -1, 1, 0)));
    const Ray ray{.origin = {2, 0, 0}, .direction = {-1, 0, 0}};
    const SurfacePoint apex = surfaceAt(cone, ray, {.t = 2});
    checkNear(apex.position, {0, 0, 0}, 1e-15);
    checkNear(apex.geometricNormal, {1, 0, 0}, 1e-15);
    CHECK(apex.offset < 1e-12);
    // Beside it the gradient is 1e-9, yet the surface is no less sharp: the cone has no size of its own.
    const SurfacePoint beside = surfaceAt(cone, {.origin = {2, 1e-9, 0}, .direction = {-1, 0, 0}}, {.t = 2 - 1e-9});
    checkNear(beside.geometricNormal, {std::sqrt(0.5), -std::sqrt(0.5), 0}, 1e-6);
    CHECK(beside.offset < 1e-12);
}
