// Instances of meshes against the same triangles in world space; and meshes as solids: how often a line crosses them.
#include "reference/shapes/instance.h"

#include "reference/world.h"
#include "unit/reference/random_solids.h"

#include <cmath>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

Instance instanceOf(const Mesh& mesh) {
    return {.tree = std::make_shared<const MeshTree>(mesh), .map = {}};
}

// Crossings must alternate, ascend, and be an even number.
void checkComplete(const Crossings& list) {
    REQUIRE(list.size() % 2 == 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
        CHECK(list[i].entering == (i % 2 == 0));
        CHECK(std::isfinite(list[i].at.t));
        CHECK((i == 0 || list[i - 1].at.t <= list[i].at.t));
    }
}

} // namespace

TEST_CASE("an instance is hit where its triangles, transformed to the world, are hit") {
    Random random;
    const Mesh mesh = ballMesh();
    Instance instance = instanceOf(mesh);
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
        const glm::dmat4 map = randomMap(random, 5);
        instance.map = Affine(map);
        const auto corner = [&](std::uint32_t index) {
            return dvec3(map * glm::dvec4(dvec3(mesh.positions[index]), 1));
        };
        for (int k = 0; k < 20; ++k) {
            const dvec3 way = random.direction();
            const Ray ray{.origin = dvec3(map[3]) + random.inCube(1) - 4.0 * way, .direction = way};
            std::optional<ShapeHit> expected;
            for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
                const glm::uvec3& at = mesh.triangles[triangle];
                auto hit = intersectTriangle(ray, {{corner(at.x), corner(at.y), corner(at.z)}});
                if (hit && (!expected || hit->t < expected->t)) {
                    hit->part = triangle;
                    expected = hit;
                }
            }
            const auto actual = intersectInstance(ray, instance, Wanted::Nearest);
            REQUIRE(actual.has_value() == expected.has_value());
            CHECK(intersectInstance(ray, instance, Wanted::Any).has_value() == expected.has_value());
            if (!expected) {
                continue;
            }
            ++hits;
            CHECK_THAT(actual->t, WithinAbs(expected->t, 1e-12));
            CHECK(actual->part == expected->part);
            CHECK_THAT(actual->u, WithinAbs(expected->u, 1e-11));
            CHECK_THAT(actual->v, WithinAbs(expected->v, 1e-11));
            // A ball's front faces outwards: that of a convex mesh shows to every ray from outside, mirrored or not.
            const SurfacePoint point = surfaceAt(instance, ray, *actual);
            CHECK(glm::dot(point.geometricNormal, way) < 0);
            checkNear(point.position, ray.origin + actual->t * way, 1e-12);
        }
    }
    CHECK(hits > 1000);
}

TEST_CASE("ten thousand instances keep one mesh and one tree") {
    Scene scene;
    scene.render.radius = 1;
    scene.meshes = {ballMesh()};
    for (int i = 0; i < 10000; ++i) {
        const dvec3 place(3.0 * (i % 100), 0, 3.0 * (i / 100)); // NOLINT(bugprone-integer-division): the row
        addObject(scene, MeshInstance{.mesh = 0, .objectToWorld = glm::translate(glm::dmat4(1), place)}, std::nullopt);
    }
    const World world = prepareWorld(scene);
    const auto treeOf = [&](std::size_t object) {
        return std::get<Instance>(std::get<Solid>(world.geometry[object])).tree;
    };
    CHECK(treeOf(0) == treeOf(9999));
    CHECK(treeOf(0).use_count() == 10001); // and the one asked for here
    // Every one is met from above at its top, a corner of the octahedron: 5 - 1.
    for (std::uint32_t i = 0; i < 10000; i += 97) {
        const dvec3 place(3.0 * (i % 100), 5, 3.0 * (i / 100)); // NOLINT(bugprone-integer-division): the row
        const auto hit = traceClosest(world, {.origin = place, .direction = {0, -1, 0}});
        REQUIRE(hit);
        CHECK(hit->object == i);
        CHECK(hit->t == 4);
    }
}

TEST_CASE("lines exactly through corners and edges of a closed mesh cross it an even number of times") {
    // The cube's diagonals, its faces' diagonals, its edges, and lines in its faces: all coordinates are exact.
    const Instance cube = instanceOf(cubeMesh());
    std::vector<dvec3> places;
    places.reserve(125);
    for (int i = 0; i < 125; ++i) {
        const int layer = i / 25;
        places.emplace_back(i % 5 / 2.0 - 0.5, i / 5 % 5 / 2.0 - 0.5, layer / 2.0 - 0.5);
    }
    int through = 0;
    for (const dvec3& place : places) {
        for (int i = 0; i < 27; ++i) {
            const dvec3 direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            if (direction == dvec3(0)) {
                continue;
            }
            const Crossings list = crossings(cube, {.origin = place, .direction = direction});
            checkComplete(list);
            through += list.empty() ? 0 : 1;
            // Through the open inside of the convex cube: in and out once
            const bool inside = isInside(cube, place);
            if (glm::all(glm::lessThan(glm::abs(place - 0.5), dvec3(0.5)))) {
                CHECK(inside);
                CHECK(list.size() == 2);
            } else if (glm::any(glm::greaterThan(glm::abs(place - 0.5), dvec3(0.5)))) {
                CHECK_FALSE(inside);
            }
        }
    }
    CHECK(through > 500);
}

TEST_CASE("lines aimed at corners and edges of a rotated closed mesh cross it an even number of times") {
    Random random;
    const Mesh mesh = ballMesh();
    Instance ball = instanceOf(mesh);
    for (int i = 0; i < 20000; ++i) {
        const glm::dmat4 map = randomMap(random, 10);
        ball.map = Affine(map);
        const glm::uvec3& at = mesh.triangles[static_cast<std::size_t>(i) % mesh.triangles.size()];
        const double weight = i % 3 == 0 ? 0 : random.unit();
        const dvec3 local = glm::mix(dvec3(mesh.positions[at.x]), dvec3(mesh.positions[at.y]), weight);
        const dvec3 target(map * glm::dvec4(local, 1));
        const dvec3 origin = target + random.inCube(3);
        if (origin == target) {
            continue;
        }
        checkComplete(crossings(ball, {.origin = origin, .direction = glm::normalize(target - origin)}));
    }
}

TEST_CASE("inside a mesh is where its winding number is not 0: a cube within a cube, both outwards, makes no hole") {
    Mesh nested = cubeMesh();
    const Mesh cube = cubeMesh();
    for (const glm::vec3& p : cube.positions) {
        nested.positions.push_back(glm::vec3(0.25F) + 0.5F * p);
    }
    for (const glm::uvec3& t : cube.triangles) {
        nested.triangles.push_back(t + 8U);
    }
    const Ray line{.origin = {-1, 0.5, 0.4}, .direction = {1, 0, 0}};
    const Crossings full = crossings(instanceOf(nested), line);
    REQUIRE(full.size() == 2);
    CHECK(full[0].at.t == 1);
    CHECK(full[1].at.t == 2);
    CHECK(isInside(instanceOf(nested), {0.5, 0.5, 0.5}));
    // Turned inwards, the inner one takes its inside away.
    for (std::size_t i = cube.triangles.size(); i < nested.triangles.size(); ++i) {
        std::swap(nested.triangles[i].y, nested.triangles[i].z);
    }
    const Crossings hollow = crossings(instanceOf(nested), line);
    REQUIRE(hollow.size() == 4);
    CHECK_THAT(hollow[1].at.t, WithinAbs(1.25, 1e-15));
    CHECK_THAT(hollow[2].at.t, WithinAbs(1.75, 1e-15));
    CHECK_FALSE(isInside(instanceOf(nested), {0.5, 0.5, 0.5}));
    CHECK(isInside(instanceOf(nested), {0.1, 0.5, 0.5}));
}

TEST_CASE("a degenerate triangle leaves no hole") {
    // The cube's top has a corner on one of its edges: between them a triangle that is a line.
    Mesh mesh = cubeMesh();
    mesh.positions.emplace_back(0.3F, 0, 0); // on the edge from (0, 0, 0) to (1, 0, 0)
    // That edge belongs to {0, 2, 1} and {0, 1, 4}: the first is split at the new corner, the line joins both.
    mesh.triangles[0] = {0, 2, 8};
    mesh.triangles.emplace_back(8, 2, 1);
    mesh.triangles.emplace_back(0, 8, 1);
    Random random;
    Instance instance = instanceOf(mesh);
    for (int i = 0; i < 5000; ++i) {
        const glm::dmat4 map = randomMap(random, 10);
        instance.map = Affine(map);
        const dvec3 target(map * glm::dvec4(random.unit(), 0, 0, 1));
        const dvec3 inside(map * glm::dvec4(0.4, 0.5, 0.6, 1));
        const Ray ray{.origin = inside, .direction = glm::normalize(target - inside)};
        checkComplete(crossings(instance, ray));
        const auto hit = intersectInstance(ray, instance, Wanted::Nearest);
        REQUIRE(hit);
        const SurfacePoint point = surfaceAt(instance, ray, *hit);
        CHECK_THAT(glm::length(point.geometricNormal), WithinAbs(1, 1e-12));
    }
}
