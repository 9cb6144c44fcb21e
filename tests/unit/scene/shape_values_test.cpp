// Shapes of a scene file: each is compared with its formula, written out here in the file's coordinates, at random
// points and under a transform that stretches, turns and mirrors.
#include "unit/scene/random_points.h"
#include "unit/scene/scene_test_support.h"

#include "scene/model/bounds.h"
#include "scene/model/quadric.h"
#include "scene/yaml/read_placement.h"

#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

using Catch::Matchers::WithinAbs;
using namespace hyalite;
using namespace hyalite::test;
using glm::dmat4;
using glm::dvec3;

namespace {

void checkNear(const dvec3& actual, const dvec3& expected) {
    INFO("(" << actual.x << ", " << actual.y << ", " << actual.z << ") against (" << expected.x << ", " << expected.y
             << ", " << expected.z << ")");
    CHECK(glm::length(actual - expected) <= 1e-12);
}

Shape loadShape(const std::string& shape, const std::string& transform = "[]") {
    return loadWithShape(shape, transform).objects.at(0).shape;
}

const std::string kTransform =
    "[{scale: [1.5, 2, -0.5]}, {rotate: {axis: [1, 2, 3], degrees: 50}}, {translate: [4, 5, 6]}]";
const dmat4 kMap = glm::translate(dmat4(1), dvec3(4, 5, 6)) *
                   glm::rotate(dmat4(1), glm::radians(50.0), dvec3(1, 2, 3)) *
                   glm::scale(dmat4(1), dvec3(1.5, 2, -0.5));

bool isWithin(const Bounds& box, const dvec3& p) {
    return glm::all(glm::greaterThanEqual(p, box.low)) && glm::all(glm::lessThanEqual(p, box.high));
}

// True if the solid contains a world point, from the struct's own definition.
bool holds(const Shape& shape, const dvec3& world) {
    const auto local = [&](const dmat4& objectToWorld) {
        return dvec3(glm::inverse(objectToWorld) * glm::dvec4(world, 1));
    };
    if (const auto* quadric = std::get_if<Quadric>(&shape)) {
        const dvec3 p = local(quadric->objectToWorld);
        return evaluate(quadric->form, p) <= 0 && isWithin(quadric->clip, p);
    }
    if (const auto* torus = std::get_if<Torus>(&shape)) {
        const dvec3 p = local(torus->objectToWorld);
        return std::hypot(std::hypot(p.x, p.z) - torus->major, p.y) <= torus->minor;
    }
    if (const auto* plane = std::get_if<Plane>(&shape)) {
        return glm::dot(world - plane->point, plane->normal) <= 0;
    }
    const auto& sphere = std::get<Sphere>(shape);
    return glm::length(world - sphere.center) <= sphere.radius;
}

// The shape must contain the image of each point that satisfies the formula, and no other.
void checkHolds(const std::string& text, const std::function<bool(const dvec3&)>& formula) {
    INFO(text);
    const Shape plain = loadShape(text);
    const Shape mapped = loadShape(text, kTransform);
    Object object;
    object.shape = mapped;
    const Bounds bounds = worldBounds(Scene{}, object);
    const Bounds padded{bounds.low - 1e-12, bounds.high + 1e-12}; // the image of a point is rounded
    RandomPoints random(7);
    constexpr int kPoints = 4000;
    int inside = 0;
    for (int i = 0; i < kPoints; ++i) {
        const dvec3 p = random.inCube(3);
        const dvec3 image(kMap * glm::dvec4(p, 1));
        const bool expected = formula(p);
        REQUIRE(holds(plain, p) == expected);
        REQUIRE(holds(mapped, image) == expected);
        if (expected) {
            ++inside;
            // A plane is the half-space behind it only within a csg; its own bounds are those of the surface
            REQUIRE((std::holds_alternative<Plane>(mapped) || isWithin(padded, image)));
        }
    }
    CHECK(inside > 20);
    CHECK(inside < kPoints - 20);
}

double square(double x) {
    return x * x;
}

} // namespace

TEST_CASE("a sphere holds the points within its radius, stretched or not") {
    checkHolds("{type: sphere, center: [1, 0, -0.5], radius: 1.2}",
               [](const dvec3& p) { return glm::length(p - dvec3(1, 0, -0.5)) <= 1.2; });
    CHECK(std::holds_alternative<Sphere>(loadShape("{type: sphere, radius: 1}", "[{scale: -2}]")));
    CHECK(std::holds_alternative<Quadric>(loadShape("{type: sphere, radius: 1}", "[{scale: [1, 1, 2]}]")));
}

TEST_CASE("a stretched sphere is an ellipsoid about its own centre") {
    const auto ellipsoid = std::get<Quadric>(
        loadShape("{type: sphere, center: [5, 0, 0], radius: 0.5}", "[{scale: [2, 1, 1]}, {translate: [0, 3, 0]}]"));
    // x^2 + y^2 + z^2 - 1/4 about (5, 0, 0), which goes to (10, 3, 0); it reaches 1, 1/2, 1/2 there.
    CHECK(ellipsoid.form.a == 1);
    CHECK(ellipsoid.form.d == 0);
    CHECK(ellipsoid.form.j == -0.25);
    checkNear(ellipsoid.objectToWorld[3], {10, 3, 0});
    const Bounds box = worldBounds(ellipsoid);
    checkNear(box.low, {9, 2.5, -0.5});
    checkNear(box.high, {11, 3.5, 0.5});
}

TEST_CASE("a box holds the points between its corners") {
    checkHolds("{type: box, min: [-1, -2, 0.5], max: [2, 0.5, 1.5]}", [](const dvec3& p) {
        return p.x >= -1 && p.x <= 2 && p.y >= -2 && p.y <= 0.5 && p.z >= 0.5 && p.z <= 1.5;
    });
}

TEST_CASE("a cylinder and a cone hold the points within their radius of the axis") {
    const dvec3 base(1, -1, 0.5);
    const dvec3 top(-1, 2, 1);
    const auto within = [&](double baseRadius, double topRadius) {
        return [=](const dvec3& p) {
            const dvec3 axis = top - base;
            const double t = glm::dot(p - base, axis) / glm::dot(axis, axis); // 0 at the base, 1 at the top
            const double radius = baseRadius + t * (topRadius - baseRadius);
            return t >= 0 && t <= 1 && glm::length(p - base - t * axis) <= radius;
        };
    };
    const std::string ends = "base: [1, -1, 0.5], top: [-1, 2, 1]";
    checkHolds("{type: cylinder, " + ends + ", radius: 0.8}", within(0.8, 0.8));
    checkHolds("{type: cone, " + ends + ", radius: 1.5}", within(1.5, 0));
    checkHolds("{type: cone, " + ends + ", radius: 1.5, top_radius: 0.5}", within(1.5, 0.5));
    checkHolds("{type: cone, " + ends + ", radius: 0, top_radius: 1.5}", within(0, 1.5));
    checkHolds("{type: cone, " + ends + ", radius: 1, top_radius: 1}", within(1, 1));
}

TEST_CASE("an open cylinder and an open cone have no caps") {
    const std::string ends = "base: [0, 0, 0], top: [0, 1, 0], radius: 1";
    CHECK(std::get<Quadric>(loadShape("{type: cylinder, " + ends + "}")).capped);
    CHECK_FALSE(std::get<Quadric>(loadShape("{type: cylinder, open: true, " + ends + "}")).capped);
    CHECK_FALSE(std::get<Quadric>(loadShape("{type: cone, open: true, " + ends + "}")).capped);
    CHECK(std::get<Quadric>(loadShape("{type: cone, open: false, " + ends + "}")).capped);
}

TEST_CASE("a torus holds the points near its circle") {
    checkHolds("{type: torus, major: 1.5, minor: 0.5}",
               [](const dvec3& p) { return square(std::hypot(p.x, p.z) - 1.5) + p.y * p.y <= 0.25; });
    checkHolds("{type: torus, center: [0.5, 1, 0], axis: [0, 0, -2], major: 1.5, minor: 0.5}",
               [](const dvec3& p) { return square(std::hypot(p.x - 0.5, p.y - 1) - 1.5) + p.z * p.z <= 0.25; });
}

TEST_CASE("the bounds of a turned torus touch it") {
    // Its circle of radius 3 in the plane with the normal (1, 1, 0)/sqrt(2) reaches 3/sqrt(2) along x and y and 3 along
    // z; the tube adds 1 all around.
    const Shape torus = loadShape("{type: torus, axis: [1, 1, 0], major: 3, minor: 1}");
    const Bounds box = worldBounds(std::get<Torus>(torus));
    checkNear(box.high, {3 / std::sqrt(2) + 1, 3 / std::sqrt(2) + 1, 4});
    checkNear(box.low, -box.high);
}

TEST_CASE("named quadrics hold the points of their formulas, about their centre and along their axis") {
    checkHolds("{type: ellipsoid, center: [0.5, 0, 0], radii: [1, 2, 1.5]}",
               [](const dvec3& p) { return square(p.x - 0.5) + square(p.y / 2) + square(p.z / 1.5) <= 1; });
    checkHolds("{type: paraboloid, radii: [1, 0.5, 2], clip: {max: [null, 2, null]}}",
               [](const dvec3& p) { return p.x * p.x + p.z * p.z / 4 <= p.y / 0.5 && p.y <= 2; });
    checkHolds("{type: hyperboloid_one_sheet, radii: [0.5, 1, 0.7], clip: {min: [null, -1, null], max: [2, 2, 2]}}",
               [](const dvec3& p) {
                   return square(p.x / 0.5) - p.y * p.y + square(p.z / 0.7) <= 1 && p.y >= -1 && p.y <= 2 && //
                          p.x <= 2 && p.z <= 2;
               });
    checkHolds("{type: hyperboloid_two_sheets, radii: [1, 0.5, 1]}",
               [](const dvec3& p) { return p.x * p.x - square(p.y / 0.5) + p.z * p.z <= -1; });
    checkHolds("{type: hyperbolic_paraboloid, radii: [1, 2, 0.5]}",
               [](const dvec3& p) { return p.y / 2 <= p.x * p.x - square(p.z / 0.5); });
}

TEST_CASE("an axis turns a shape by the smallest angle from y") {
    // To +z: about x by 90 degrees, which takes y to z and z to -y; so a point's own y is its z, and its own z is -y.
    checkHolds("{type: ellipsoid, axis: [0, 0, 3], radii: [0.5, 2, 1]}",
               [](const dvec3& p) { return square(p.x / 0.5) + square(p.z / 2) + square(p.y) <= 1; });
    // To +x: about z by -90 degrees, which takes y to x and x to -y. The clip box goes with it: own x >= 0 is y <= 0.
    checkHolds(
        "{type: paraboloid, center: [-1, 0, 0], axis: [1, 0, 0], radii: [1, 1, 2], clip: {min: [0, null, null]}}",
        [](const dvec3& p) { return p.y * p.y + p.z * p.z / 4 <= p.x + 1 && p.y <= 0; });
    // To -y: half a turn about x.
    checkHolds("{type: paraboloid, axis: [0, -1, 0], radii: [1, 1, 1], clip: {max: [null, null, 0.5]}}",
               [](const dvec3& p) { return p.x * p.x + p.z * p.z <= -p.y && -p.z <= 0.5; });
}

TEST_CASE("the turn from y to an axis is a rotation, also near -y") {
    for (const dvec3& axis : {dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(1, 0, 0), dvec3(1e-9, -1, 2e-9),
                              dvec3(-1e-6, -1, 1e-5), dvec3(3, -4, 5), dvec3(1e-7, 2, 0), dvec3(-1, 1e-12, 1)}) {
        INFO(axis.x << ", " << axis.y << ", " << axis.z);
        const glm::dmat3 turn = rotationFromY(axis);
        checkNear(turn[1], glm::normalize(axis));
        checkNear(glm::cross(turn[2], turn[0]), turn[1]);
        CHECK_THAT(glm::dot(turn[0], turn[0]), WithinAbs(1, 1e-12));
        CHECK_THAT(glm::dot(turn[2], turn[2]), WithinAbs(1, 1e-12));
        CHECK_THAT(glm::dot(turn[0], turn[2]), WithinAbs(0, 1e-12));
        // By the smallest angle: what is perpendicular to both y and the axis stays.
        const dvec3 hinge = glm::cross(dvec3(0, 1, 0), axis);
        checkNear(turn * hinge, hinge);
    }
}

TEST_CASE("a quadric holds the points where its polynomial is not positive") {
    checkHolds("{type: quadric, coefficients: [1, 0.5, 0, 0.25, 2, 0, 0, 3, -0.5, -4]}", [](const dvec3& p) {
        return p.x * p.x + p.x * p.y + 0.5 * p.x + 2 * p.y * p.y + 3 * p.z * p.z - p.z - 4 <= 0;
    });
    // Its box alone, open to one side.
    checkHolds("{type: quadric, coefficients: [0, 0, 0, 0, 0, 0, 0, 0, 0, -3], clip: {min: [-1, null, 0]}}",
               [](const dvec3& p) { return p.x >= -1 && p.z >= 0; });
    const auto open = std::get<Quadric>(loadShape("{type: quadric, coefficients: [1, 0, 0, 0, 1, 0, 0, 1, 0, -1], "
                                                  "clip: {min: [0, null, null], max: [null, null, null]}, "
                                                  "caps: false}"));
    CHECK_FALSE(open.capped);
    CHECK(open.clip.low.x == 0);
    // 4x the sphere of radius 1/2 is itself after its largest coefficient is made 1.
    const auto sphere = std::get<Quadric>(loadShape("{type: quadric, coefficients: [4, 0, 0, 0, 4, 0, 0, 4, 0, -1]}"));
    CHECK(sphere.form.a == 1);
    CHECK(sphere.form.j == -0.25);
    CHECK(sphere.clip.high == Bounds::everything().high);
}

TEST_CASE("a plane follows any affine map, and so does what is behind it") {
    checkHolds("{type: plane, point: [0, 0.5, 0], normal: [1, 2, -2]}",
               [](const dvec3& p) { return p.x + 2 * (p.y - 0.5) - 2 * p.z <= 0; });
    const auto plane = std::get<Plane>(loadShape("{type: plane, point: [1, 2, 3], normal: [0, 5, 0]}"));
    CHECK(plane.point == dvec3(1, 2, 3));
    CHECK(plane.normal == dvec3(0, 1, 0));
}

TEST_CASE("a stretched disk is an ellipse, and a mirrored one keeps its front where the mirror puts it") {
    const std::string text = "{type: disk, center: [1, 2, 3], normal: [0, 0, 7], radius: 2}";
    const auto disk = std::get<Disk>(loadShape(text, "[{scale: [3, 1, 1]}]"));
    checkNear(disk.center, {3, 2, 3});
    checkNear(glm::normalize(glm::cross(disk.axis0, disk.axis1)), {0, 0, 1});
    // Half-axes 6 and 2 along x and y.
    const Bounds box = worldBounds(disk);
    checkNear(box.low, {-3, 0, 3});
    checkNear(box.high, {9, 4, 3});

    const auto across = std::get<Disk>(loadShape(text, "[{scale: [-1, 1, 1]}]"));
    checkNear(glm::normalize(glm::cross(across.axis0, across.axis1)), {0, 0, 1});
    const auto along = std::get<Disk>(loadShape(text, "[{scale: [1, 1, -1]}]"));
    checkNear(glm::normalize(glm::cross(along.axis0, along.axis1)), {0, 0, -1});
}

TEST_CASE("a shape's own transform goes before its object's, and its own material before too") {
    const Scene scene =
        loadWithShape("{type: sphere, radius: 1, transform: [{translate: [1, 0, 0]}], material: red}", "[{scale: 2}]");
    checkNear(std::get<Sphere>(scene.objects.at(0).shape).center, {2, 0, 0});
    CHECK(scene.objects.at(0).material == 1);
}

TEST_CASE("bounded shapes have finite bounds, even if only their formula implies it") {
    const auto isBounded = [](const std::string& text) {
        const Scene scene = loadWithShape(text, kTransform);
        return isFinite(worldBounds(scene, scene.objects.at(0)));
    };
    CHECK(isBounded("{type: cylinder, base: [0, 0, 0], top: [1, 1, 0], radius: 1, open: true}"));
    CHECK(isBounded("{type: cone, base: [0, 0, 0], top: [1, 1, 0], radius: 1}"));
    CHECK(isBounded("{type: paraboloid, radii: [1, 1, 1], clip: {max: [null, 2, null]}}"));
    CHECK(isBounded("{type: hyperboloid_one_sheet, radii: [1, 1, 1], clip: {min: [null, 0, null], "
                    "max: [null, 1, null]}, caps: false}"));
    CHECK(isBounded("{type: ellipsoid, radii: [1, 2, 3]}"));
    CHECK_FALSE(isBounded("{type: paraboloid, radii: [1, 1, 1]}"));
    CHECK_FALSE(isBounded("{type: hyperbolic_paraboloid, radii: [1, 1, 1], clip: {min: [null, 0, null], "
                          "max: [null, 1, null]}}"));
    CHECK_FALSE(isBounded("{type: plane, point: [0, 0, 0], normal: [1, 2, 3]}"));
}
