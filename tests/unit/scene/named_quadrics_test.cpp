// The coefficients of the named quadrics, derived by hand.
#include "scene/model/named_quadrics.h"

#include "scene/model/quadric.h"

#include <array>
#include <catch2/catch_test_macros.hpp>

using namespace hyalite;
using glm::dvec3;

namespace {

// In the order of the coefficients' names, a to j.
std::array<double, 10> coefficients(const QuadricForm& q) {
    return {q.a, q.b, q.c, q.d, q.e, q.f, q.g, q.h, q.i, q.j};
}

std::array<double, 10> form(double a, double e, double g, double h, double j) {
    return {a, 0, 0, 0, e, 0, g, h, 0, j};
}

dvec3 origin(const Quadric& quadric) {
    return quadric.objectToWorld[3];
}

} // namespace

TEST_CASE("an ellipsoid's squares are over those of its half-axes") {
    // x^2 + y^2/4 + z^2/16 - 1
    CHECK(coefficients(ellipsoidForm({1, 2, 4})) == form(1, 0.25, 0, 0.0625, -1));
}

TEST_CASE("a paraboloid's rim has its half-axes at its height") {
    // x^2/4 + z^2 - y/0.5: the term in y is 2 g y
    CHECK(coefficients(paraboloidForm({2, 0.5, 1})) == form(0.25, 0, -1, 1, 0));
}

TEST_CASE("hyperboloids turn the sign of y") {
    // x^2 - y^2/4 + 4 z^2 - 1 over 4, and x^2 - y^2 + z^2 + 1
    CHECK(coefficients(hyperboloidOneSheetForm({1, 2, 0.5})) == form(0.25, -0.0625, 0, 1, -0.25));
    CHECK(coefficients(hyperboloidTwoSheetsForm({1, 1, 1})) == form(1, -1, 0, 1, 1));
}

TEST_CASE("below a hyperbolic paraboloid is inside") {
    // y/2 - x^2 + z^2
    CHECK(coefficients(hyperbolicParaboloidForm({1, 2, 1})) == form(-1, 0, 0.25, 1, 0));
}

TEST_CASE("a box is what its clip box caps") {
    const Quadric box = boxQuadric({1, 2, 3});
    CHECK(coefficients(box.form) == form(0, 0, 0, 0, -1));
    CHECK(box.clip.low == dvec3(-1, -2, -3));
    CHECK(box.clip.high == dvec3(1, 2, 3));
    CHECK(box.capped);
}

TEST_CASE("a cylinder is written about its middle") {
    // x^2 + z^2 - 4 over 4, between y = -3 and 3, the base at the world's origin
    const Quadric cylinder = cylinderQuadric(2, 6);
    CHECK(coefficients(cylinder.form) == form(0.25, 0, 0, 0.25, -1));
    CHECK(cylinder.clip.low.y == -3);
    CHECK(cylinder.clip.high.y == 3);
    CHECK(cylinder.clip.high.x > 2); // the box must not cut the side
    CHECK(cylinder.clip.high.x < 2.1);
    CHECK(origin(cylinder) == dvec3(0, 3, 0));
}

TEST_CASE("a cone is written about its smaller end") {
    // To a point: the radius at y below it is -y/2, so x^2 + z^2 - y^2/4.
    const Quadric pointed = coneQuadric(2, 0, 4);
    CHECK(coefficients(pointed.form) == form(1, -0.25, 0, 1, 0));
    CHECK(pointed.clip.low.y == -4);
    CHECK(pointed.clip.high.y == 0);
    CHECK(origin(pointed) == dvec3(0, 4, 0));

    // From radius 1 to 3 over 4: x^2 + z^2 - (1 + y/2)^2 = x^2 - y^2/4 - y + z^2 - 1, the term in y being 2 g y.
    const Quadric stump = coneQuadric(1, 3, 4);
    CHECK(coefficients(stump.form) == form(1, -0.25, -0.5, 1, -1));
    CHECK(stump.clip.low.y == 0);
    CHECK(stump.clip.high.y == 4);
    CHECK(stump.clip.high.x > 3);
    CHECK(stump.clip.high.x < 3.1);
    CHECK(origin(stump) == dvec3(0, 0, 0));

    // Ends alike make a cylinder: x^2 + z^2 - 1.
    CHECK(coefficients(coneQuadric(1, 1, 4).form) == form(1, 0, 0, 1, -1));
}
