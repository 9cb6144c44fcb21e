// One ray against one shape: hits derived by hand, from inside and outside, grazing and far away.
#include "reference/shapes/geometry.h"

#include "reference/shapes/triangle.h"
#include "unit/reference/support.h"

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

Triangle makeTriangle(const dvec3& a, const dvec3& b, const dvec3& c) {
    return {{a, b, c}};
}

} // namespace

TEST_CASE("a ray through a sphere's centre meets it one radius before the centre") {
    const auto hit =
        intersectSphere({.origin = {0, 0, 5}, .direction = {0, 0, -1}}, {.center = {0, 0, 0}, .radius = 1});
    REQUIRE(hit);
    CHECK(hit->t == 4); // 5 - 1
}

TEST_CASE("a ray passing a unit sphere's centre at 0.6 enters 0.8 before the point of closest approach") {
    const auto hit = intersectSphere({.origin = {-2, 0.6, 0}, .direction = {1, 0, 0}}, {});
    REQUIRE(hit);
    CHECK_THAT(hit->t, WithinAbs(1.2, 1e-15)); // 2 - sqrt(1 - 0.36)
}

TEST_CASE("a ray that starts inside a sphere meets the far side") {
    const auto hit = intersectSphere({.origin = {0.5, 0, 0}, .direction = {1, 0, 0}}, {});
    REQUIRE(hit);
    CHECK_THAT(hit->t, WithinAbs(0.5, 1e-15));
    const auto back = intersectSphere({.origin = {0.5, 0, 0}, .direction = {-1, 0, 0}}, {});
    REQUIRE(back);
    CHECK_THAT(back->t, WithinAbs(1.5, 1e-15));
}

TEST_CASE("a tangent ray touches the sphere, one beside it does not") {
    const auto hit = intersectSphere({.origin = {-2, 1, 0}, .direction = {1, 0, 0}}, {});
    REQUIRE(hit);
    CHECK(hit->t == 2);
    CHECK_FALSE(intersectSphere({.origin = {-2, 1 + 1e-15, 0}, .direction = {1, 0, 0}}, {}));
}

TEST_CASE("a sphere ten thousand kilometres away is hit without loss of precision") {
    // The chord at height 0.6 begins at 1e7 - 0.8. Rounding moves the closest point by 1e7 * 2^-53 = 1e-9 at most,
    // while b^2 - 4ac would be wrong by 1e14 * 2^-53 = 0.01.
    const auto hit =
        intersectSphere({.origin = {0, 0.6, 0}, .direction = {1, 0, 0}}, {.center = {1e7, 0, 0}, .radius = 1});
    REQUIRE(hit);
    CHECK_THAT(hit->t, WithinAbs(1e7 - 0.8, 1e-8));
}

TEST_CASE("a sphere behind the ray or beyond its end is not met") {
    CHECK_FALSE(intersectSphere({.origin = {0, 0, 5}, .direction = {0, 0, 1}}, {}));
    CHECK_FALSE(intersectSphere({.origin = {0, 0, 5}, .direction = {0, 0, -1}, .tMax = 3.9}, {}));
}

TEST_CASE("a parallelogram is met at its own coordinates, from either side") {
    // (1.75, 0.5) = u (2, 0) + v (1, 1): v = 0.5, u = (1.75 - 0.5) / 2.
    const Quad quad{.corner = {0, 0, 0}, .edge0 = {2, 0, 0}, .edge1 = {1, 1, 0}};
    for (const double side : {1.0, -1.0}) {
        const auto hit = intersectQuad({.origin = {1.75, 0.5, 3 * side}, .direction = {0, 0, -side}}, quad);
        REQUIRE(hit);
        CHECK(hit->t == 3);
        CHECK_THAT(hit->u, WithinAbs(0.625, 1e-15));
        CHECK_THAT(hit->v, WithinAbs(0.5, 1e-15));
    }
    // At height 0.5 the parallelogram spans x from 0.5 to 2.5.
    CHECK_FALSE(intersectQuad({.origin = {0.49, 0.5, 3}, .direction = {0, 0, -1}}, quad));
    CHECK(intersectQuad({.origin = {0.51, 0.5, 3}, .direction = {0, 0, -1}}, quad));
    CHECK_FALSE(intersectQuad({.origin = {2.51, 0.5, 3}, .direction = {0, 0, -1}}, quad));
}

TEST_CASE("a ray parallel to a parallelogram misses it, also within its plane") {
    CHECK_FALSE(intersectQuad({.origin = {-1, 0.5, 0.1}, .direction = {1, 0, 0}}, {}));
    CHECK_FALSE(intersectQuad({.origin = {-1, 0.5, 0}, .direction = {1, 0, 0}}, {}));
}

TEST_CASE("a grazing ray meets a parallelogram where the slope says") {
    // From height 1e-6 with slope 1e-6 the plane is reached after 1 in x, at u = 1 / 4; t = sqrt(1 + 1e-12).
    const Quad quad{.corner = {0, 0, -1}, .edge0 = {4, 0, 0}, .edge1 = {0, 0, 2}};
    const auto hit = intersectQuad({.origin = {0, 1e-6, 0}, .direction = glm::normalize(dvec3(1, -1e-6, 0))}, quad);
    REQUIRE(hit);
    CHECK_THAT(hit->u, WithinAbs(0.25, 1e-12));
    CHECK_THAT(hit->t, WithinAbs(1 + 5e-13, 1e-12));
}

TEST_CASE("a triangle is hit with the weights of its second and third corner, from either side") {
    const Triangle triangle = makeTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (const double side : {1.0, -1.0}) {
        // (0.25, 0.5) = 0.25 (1, 0) + 0.5 (0, 1)
        const auto hit = intersectTriangle({.origin = {0.25, 0.5, 2 * side}, .direction = {0, 0, -side}}, triangle);
        REQUIRE(hit);
        CHECK_THAT(hit->t, WithinAbs(2, 1e-15));
        CHECK_THAT(hit->u, WithinAbs(0.25, 1e-15));
        CHECK_THAT(hit->v, WithinAbs(0.5, 1e-15));
    }
    CHECK_FALSE(intersectTriangle({.origin = {0.6, 0.6, 2}, .direction = {0, 0, -1}}, triangle));
    CHECK_FALSE(intersectTriangle({.origin = {0.25, 0.5, 2}, .direction = {0, 0, 1}}, triangle));
    CHECK_FALSE(intersectTriangle({.origin = {-1, 0.25, 0}, .direction = {1, 0, 0}}, triangle)); // in its plane
}

TEST_CASE("an oblique ray hits a triangle at the same point whatever its dominant axis") {
    // Aim at the point with weights (1/2, 1/4, 1/4) of a triangle in general position.
    const Triangle triangle = makeTriangle({3, 1, -2}, {4, -1, 1}, {1, 2, 2});
    const dvec3 target = 0.5 * triangle.corners[0] + 0.25 * (triangle.corners[1] + triangle.corners[2]);
    for (const dvec3& from : {dvec3(20, 1, 1), dvec3(1, 20, 1), dvec3(1, 1, 20), dvec3(-20, 2, 3)}) {
        const auto hit = intersectTriangle({.origin = from, .direction = glm::normalize(target - from)}, triangle);
        REQUIRE(hit);
        CHECK_THAT(hit->t, WithinAbs(glm::length(target - from), 1e-13));
        CHECK_THAT(hit->u, WithinAbs(0.25, 1e-13));
        CHECK_THAT(hit->v, WithinAbs(0.25, 1e-13));
    }
}

TEST_CASE("no ray slips through the edges and corners of a closed mesh") {
    // A tetrahedron about the origin; every ray from near the centre must leave through it, most of all those aimed at
    // points of edges and at corners.
    const std::array<dvec3, 4> corners = {dvec3(1.1, 1, 0.9), dvec3(-1, -1.2, 1), dvec3(-0.9, 1, -1),
                                          dvec3(1, -1, -1.3)};
    const std::array<Triangle, 4> faces = {
        makeTriangle(corners[0], corners[1], corners[3]), makeTriangle(corners[0], corners[2], corners[1]),
        makeTriangle(corners[0], corners[3], corners[2]), makeTriangle(corners[1], corners[2], corners[3])};
    Random random;
    int missed = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto a = static_cast<std::size_t>(i % 4);
        const auto b = static_cast<std::size_t>((i + 1 + i / 4 % 3) % 4);
        const double weight = i % 7 == 0 ? 0 : random.unit();
        const dvec3 origin = random.inCube(0.1);
        const Ray ray{.origin = origin, .direction = glm::normalize(glm::mix(corners[a], corners[b], weight) - origin)};
        bool hit = false;
        for (const Triangle& face : faces) {
            hit = hit || intersectTriangle(ray, face);
        }
        missed += hit ? 0 : 1;
    }
    CHECK(missed == 0);
}

TEST_CASE("a disk ends at its rim, in the coordinates of its axes") {
    // An ellipse with semi-axes 2 and 1 at height 3, front upwards: z x x = y.
    const Disk disk{.center = {1, 3, 1}, .axis0 = {0, 0, 2}, .axis1 = {1, 0, 0}};
    const Ray ray{.origin = {1.6, 8, 2.5}, .direction = {0, -1, 0}}; // u = 0.75, v = 0.6: 0.9225 <= 1
    const auto hit = intersectDisk(ray, disk);
    REQUIRE(hit);
    CHECK(hit->t == 5);
    CHECK_THAT(hit->u, WithinAbs(0.75, 1e-15));
    CHECK_THAT(hit->v, WithinAbs(0.6, 1e-15));
    const SurfacePoint point = surfaceAt(disk, ray, *hit);
    checkNear(point.position, {1.6, 3, 2.5}, 1e-15);
    checkNear(point.geometricNormal, {0, 1, 0}, 1e-15);
    CHECK_FALSE(intersectDisk({.origin = {1.7, 8, 2.5}, .direction = {0, -1, 0}}, disk)); // 0.5625 + 0.49 > 1
    CHECK(intersectDisk({.origin = {1, 0, 2.99}, .direction = {0, 1, 0}}, disk));         // from below
    CHECK_FALSE(intersectDisk({.origin = {1, 0, 3.01}, .direction = {0, 1, 0}}, disk));
    CHECK_FALSE(intersectDisk({.origin = {-5, 3, 1}, .direction = {1, 0, 0}}, disk)); // in its plane
}

TEST_CASE("a disk with oblique axes is the ellipse that they span") {
    // u (1, 0, 0) + v (1, 1, 0): at (1, 0.5) v = 0.5, u = 0.5; at (1.4, 0.5) u = 0.9, and 0.81 + 0.25 > 1.
    const Disk disk{.center = {0, 0, 0}, .axis0 = {1, 0, 0}, .axis1 = {1, 1, 0}};
    const auto hit = intersectDisk({.origin = {1, 0.5, 1}, .direction = {0, 0, -1}}, disk);
    REQUIRE(hit);
    CHECK_THAT(hit->u, WithinAbs(0.5, 1e-15));
    CHECK_THAT(hit->v, WithinAbs(0.5, 1e-15));
    CHECK_FALSE(intersectDisk({.origin = {1.4, 0.5, 1}, .direction = {0, 0, -1}}, disk));
}

TEST_CASE("a plane is hit wherever the ray descends to it") {
    const Plane plane{.point = {0, 2, 0}, .normal = {0, 1, 0}};
    const Ray ray{.origin = {1e6, 5, 0}, .direction = {0.6, -0.8, 0}};
    const auto hit = intersectPlane(ray, plane);
    REQUIRE(hit);
    CHECK_THAT(hit->t, WithinAbs(3.75, 1e-15)); // 3 / 0.8
    checkNear(surfaceAt(plane, ray, *hit).position, {1e6 + 2.25, 2, 0}, 1e-9);
    CHECK_FALSE(intersectPlane({.origin = {0, 5, 0}, .direction = {0.6, 0.8, 0}}, plane));
    CHECK_FALSE(intersectPlane({.origin = {0, 5, 0}, .direction = {1, 0, 0}}, plane));
    CHECK_FALSE(intersectPlane({.origin = {0, 2, 0}, .direction = {1, 0, 0}}, plane));
}

TEST_CASE("as a solid, a plane is the half-space behind it") {
    const Plane plane{.point = {0, 2, 0}, .normal = {0, 1, 0}};
    const auto check = [&](const Ray& line, double entered, double left) {
        const Crossings list = crossings(plane, line);
        REQUIRE(list.size() == 2);
        CHECK(list[0].at.t == entered);
        CHECK(list[1].at.t == left);
        CHECK(list[0].entering);
        CHECK_FALSE(list[1].entering);
    };
    check({.origin = {0, 5, 0}, .direction = {0, -1, 0}}, 3, kInfinite);
    check({.origin = {0, 5, 0}, .direction = {0, 1, 0}}, -kInfinite, -3);
    check({.origin = {0, 1, 0}, .direction = {1, 0, 0}}, -kInfinite, kInfinite);
    CHECK(crossings(plane, {.origin = {0, 3, 0}, .direction = {1, 0, 0}}).empty());
    CHECK(isInside(plane, {7, 1.9, 7}));
    CHECK_FALSE(isInside(plane, {7, 2.1, 7}));
}

TEST_CASE("a line crosses a sphere twice, also behind the ray") {
    const Crossings list = crossings(Sphere{{0, 0, 0}, 2}, {.origin = {5, 0, 0}, .direction = {1, 0, 0}});
    REQUIRE(list.size() == 2);
    CHECK(list[0].at.t == -7);
    CHECK(list[1].at.t == -3);
    CHECK(list[0].entering);
    CHECK_FALSE(list[1].entering);
    CHECK(isInside(Sphere{{1, 1, 1}, 2}, {1, 1, 2.9}));
    CHECK_FALSE(isInside(Sphere{{1, 1, 1}, 2}, {1, 1, 3.1}));
}
