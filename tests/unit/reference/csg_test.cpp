// CSG with analytic crossings: each operation, nesting, coincident faces, sides and materials.
#include "reference/world.h"
#include "unit/reference/random_solids.h"

#include <cmath>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

constexpr CsgStep kLeaf = CsgStep::Leaf;
constexpr CsgStep kUnion = CsgStep::Union;
constexpr CsgStep kIntersection = CsgStep::Intersection;
constexpr CsgStep kDifference = CsgStep::Difference;

// One tree; leaf i has material i.
Scene treeOf(const std::vector<Shape>& leaves, const std::vector<CsgStep>& program) {
    Scene scene;
    scene.render.radius = 1;
    scene.meshes = {cubeMesh()};
    for (const Shape& leaf : leaves) {
        const std::size_t material = addMaterial(scene, Diffuse{});
        scene.csgLeaves.push_back({.shape = leaf, .material = material, .emission = dvec3(0), .where = {}});
    }
    addObject(scene, Csg{.firstLeaf = 0, .program = program}, std::nullopt);
    return scene;
}

struct Expected {
    double t = 0;
    std::uint32_t leaf = 0;
    bool front = false;
    std::uint32_t part = 0;
};

// All hits along the ray, one after the other: each must be there, with the leaf's material, and nothing else.
void checkHits(const Scene& scene, Ray ray, const std::vector<Expected>& expected) {
    const World world = prepareWorld(scene);
    double gone = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CAPTURE(i, expected[i].t);
        const auto hit = traceClosest(world, ray);
        REQUIRE(hit);
        CHECK_THAT(gone + hit->t, WithinAbs(expected[i].t, 1e-12));
        CHECK(hit->leaf == expected[i].leaf);
        CHECK(hit->primitive == expected[i].part);
        const Surface surface = evaluateSurface(world, ray, *hit);
        CHECK(surface.front == expected[i].front);
        CHECK(surface.material == &world.materials[expected[i].leaf]);
        const dvec3 next = leave(surface, ray.direction);
        gone += glm::dot(next - ray.origin, ray.direction);
        ray.origin = next;
    }
    CHECK_FALSE(traceClosest(world, ray));
}

const Ray kAlongX{.origin = {-5, 0, 0}, .direction = {1, 0, 0}};

// Unit spheres about x = 0 and x = 1: along the x axis from -5 the first lies at [4, 6], the second at [5, 7].
const std::vector<Shape> kSpheres{Sphere{{0, 0, 0}, 1}, Sphere{{1, 0, 0}, 1}};

} // namespace

TEST_CASE("a union is entered at its first surface and left at its last") {
    checkHits(treeOf(kSpheres, {kLeaf, kLeaf, kUnion}), kAlongX, {{4, 0, true}, {7, 1, false}});
}

TEST_CASE("an intersection is entered at the second surface and left at the first") {
    checkHits(treeOf(kSpheres, {kLeaf, kLeaf, kIntersection}), kAlongX, {{5, 1, true}, {6, 0, false}});
}

TEST_CASE("a difference ends where the subtracted solid begins, and that face is seen from inside as a back") {
    checkHits(treeOf(kSpheres, {kLeaf, kLeaf, kDifference}), kAlongX, {{4, 0, true}, {5, 1, false}});
    // From the other side the cut face shows its front: the solid's outside is the second sphere's inside.
    const Ray back{.origin = {5, 0, 0}, .direction = {-1, 0, 0}};
    checkHits(treeOf(kSpheres, {kLeaf, kLeaf, kDifference}), back, {{5, 1, true}, {6, 0, false}});
    const World world = prepareWorld(treeOf(kSpheres, {kLeaf, kLeaf, kDifference}));
    const auto hit = traceClosest(world, back);
    REQUIRE(hit);
    checkNear(evaluateSurface(world, back, *hit).geometricNormal, {1, 0, 0}, 1e-15);
}

TEST_CASE("a solid subtracted from a subtracted solid is present again") {
    // [4, 6] - ([5, 7] - [5.5, 6.5]) = [4, 5] and [5.5, 6]; the third sphere is reversed twice.
    std::vector<Shape> leaves = kSpheres;
    leaves.emplace_back(Sphere{{1, 0, 0}, 0.5});
    checkHits(treeOf(leaves, {kLeaf, kLeaf, kLeaf, kDifference, kDifference}), kAlongX,
              {{4, 0, true}, {5, 1, false}, {5.5, 2, true}, {6, 0, false}});
}

TEST_CASE("a ray may start inside") {
    const Ray inside{.origin = {0.5, 0, 0}, .direction = {1, 0, 0}};
    checkHits(treeOf(kSpheres, {kLeaf, kLeaf, kUnion}), inside, {{1.5, 1, false}});
    checkHits(treeOf(kSpheres, {kLeaf, kLeaf, kIntersection}), inside, {{0.5, 0, false}});
    checkHits(treeOf(kSpheres, {kLeaf, kLeaf, kDifference}), inside, {});
    checkHits(treeOf(kSpheres, {kLeaf, kLeaf, kDifference}), {.origin = {-0.5, 0, 0}, .direction = {1, 0, 0}},
              {{0.5, 1, false}});
}

TEST_CASE("half-spaces cut solids, and form unbounded solids") {
    // The unit sphere below y = 0.25, from above at x = 0: top of the plane at 5 - 0.25, bottom of the sphere at 6.
    const std::vector<Shape> leaves{Sphere{{0, 0, 0}, 1}, Plane{{0, 0.25, 0}, {0, 1, 0}}};
    const Ray down{.origin = {0, 5, 0}, .direction = {0, -1, 0}};
    checkHits(treeOf(leaves, {kLeaf, kLeaf, kIntersection}), down, {{4.75, 1, true}, {6, 0, false}});
    checkHits(treeOf(leaves, {kLeaf, kLeaf, kDifference}), down, {{4, 0, true}, {4.75, 1, false}});
    checkHits(treeOf(leaves, {kLeaf, kLeaf, kUnion}), down, {{4, 0, true}});
    const World world = prepareWorld(treeOf(leaves, {kLeaf, kLeaf, kUnion}));
    CHECK(world.unbounded.size() == 1);
    CHECK(isInside(world, 0, {1000, -1000, 0}));
    CHECK_FALSE(isInside(world, 0, {1000, 1000, 0}));
}

TEST_CASE("the classic: a cube rounded by a sphere, minus three cylinders") {
    // Cube of half side 1, sphere of radius 1.35, cylinders of radius 0.4 along x, y and z.
    const Scene scene = treeOf({axisBox(dvec3(-1), dvec3(1)), Sphere{dvec3(0), 1.35}, endlessCylinder(0, 0.4),
                                endlessCylinder(1, 0.4), endlessCylinder(2, 0.4)},
                               {kLeaf, kLeaf, kIntersection, kLeaf, kLeaf, kUnion, kLeaf, kUnion, kDifference});
    checkHits(scene, kAlongX, {}); // through the bore
    // At y = 0.5 the sphere reaches x = 1.254 only, beyond the cube. The bore along y, at z = 0, spans |x| < 0.4; those
    // along x and z are 0.5 away.
    checkHits(scene, {.origin = {-5, 0.5, 0}, .direction = {1, 0, 0}},
              {{4, 0, true, 1}, {4.6, 3, false}, {5.4, 3, true}, {6, 0, false, 2}});
    // At y = z = 0.9 the sphere cuts the cube's edge off: x^2 = 1.8225 - 1.62 = 0.45^2.
    checkHits(scene, {.origin = {-5, 0.9, 0.9}, .direction = {1, 0, 0}}, {{4.55, 1, true}, {5.45, 1, false}});
    // From the middle of the empty inside along (0, 1, 1) / sqrt 2: the bores along y and z end at 0.4 across, so at
    // 0.4 sqrt 2 from the middle; the sphere at 1.35 ends before the cube at sqrt 2.
    const double half = std::sqrt(0.5);
    checkHits(scene, {.origin = {0, 0, 0}, .direction = {0, half, half}}, {{0.4 / half, 3, true}, {1.35, 1, false}});
}

TEST_CASE("a closed mesh cuts like the solid that it bounds") {
    // The unit cube as a mesh, taken from a sphere of radius 2 about the origin. Along x at y = 0.5, z = 0.4 the sphere
    // lies within |x| = sqrt(4 - 0.41), the cube at [0, 1]: its sides x = 0 and x = 1 are triangles 8, 9 and 10, 11.
    const Scene scene = treeOf({Sphere{dvec3(0), 2}, MeshInstance{}}, {kLeaf, kLeaf, kDifference});
    const double reach = std::sqrt(3.59);
    // Of each pair the first is that of y + z < 1.
    checkHits(scene, {.origin = {-5, 0.5, 0.4}, .direction = {1, 0, 0}},
              {{5 - reach, 0, true}, {5, 1, false, 8}, {6, 1, true, 10}, {5 + reach, 0, false}});
}

TEST_CASE("abutting boxes in a union show no face between them") {
    for (const bool swapped : {false, true}) {
        std::vector<Shape> leaves{axisBox({0, 0, 0}, {1, 1, 1}), axisBox({1, 0, 0}, {2, 1, 1})};
        if (swapped) {
            std::swap(leaves[0], leaves[1]);
        }
        const std::uint32_t left = swapped ? 1 : 0;
        checkHits(treeOf(leaves, {kLeaf, kLeaf, kUnion}), {.origin = {-5, 0.5, 0.5}, .direction = {1, 0, 0}},
                  {{5, left, true, 1}, {7, 1 - left, false, 2}});
    }
}

TEST_CASE("boxes that abut up to rounding, in any rotation, show no face between them either") {
    Random random;
    for (int i = 0; i < 2000; ++i) {
        const glm::dmat4 map = randomMap(random, 3);
        Quadric left = axisBox({-1, -1, -1}, {0.1, 1, 1});
        Quadric right = axisBox({0.1, -1, -1}, {1, 1, 1});
        left.objectToWorld = map;
        // The same place by another way: half as large, and the map twice
        right.clip = {0.5 * right.clip.low, 0.5 * right.clip.high};
        right.objectToWorld = glm::scale(map, dvec3(2));
        const World world = prepareWorld(treeOf({left, right}, {kLeaf, kLeaf, kUnion}));
        const auto at = [&](double x) {
            return dvec3(map * glm::dvec4(x, random.between(-0.9, 0.9), random.between(-0.9, 0.9), 1));
        };
        // From inside the left box to the outside behind the right one: nothing before the far face.
        const dvec3 from = at(random.between(-0.9, 0));
        const dvec3 to = at(1);
        const auto hit = traceClosest(world, {.origin = from, .direction = glm::normalize(to - from)});
        REQUIRE(hit);
        CHECK_THAT(hit->t, WithinAbs(glm::length(to - from), 1e-12));
        CHECK(hit->leaf == 1);
        CHECK(hit->primitive == 2);
    }
}

TEST_CASE("a solid minus itself is empty") {
    Random random;
    for (int i = 0; i < 2000; ++i) {
        const Shape solid = randomSolid(random, i % (kSolidKinds - 1), 1);
        Scene scene = treeOf({solid, solid}, {kLeaf, kLeaf, kDifference});
        scene.meshes.push_back(ballMesh());
        const World world = prepareWorld(scene);
        for (int k = 0; k < 5; ++k) {
            CHECK_FALSE(traceClosest(world, {.origin = random.inCube(2), .direction = random.direction()}));
        }
    }
}

TEST_CASE("of coincident faces, the first leaf's is hit") {
    // Two boxes with the same top, overlapping for x in [0.5, 1].
    std::vector<Shape> leaves{axisBox({0, 0, 0}, {1, 1, 1}), axisBox({0.5, -1, 0}, {1.5, 1, 1})};
    for (int order = 0; order < 2; ++order) {
        const Ray down{.origin = {0.75, 3, 0.5}, .direction = {0, -1, 0}};
        for (const CsgStep step : {kUnion, kIntersection}) {
            const World world = prepareWorld(treeOf(leaves, {kLeaf, kLeaf, step}));
            const auto hit = traceClosest(world, down);
            REQUIRE(hit);
            CHECK(hit->t == 2);
            CHECK(hit->leaf == 0);
            CHECK(hit->primitive == 4);
        }
        std::swap(leaves[0], leaves[1]);
    }
}

TEST_CASE("of coincident faces, only a deciding one is hit") {
    // The first leaf's top lies in the same plane, but it is only there to be cut by a sphere far away: nothing of it
    // is left.
    const std::vector<Shape> leaves{axisBox({0, 0, 0}, {1, 1, 1}), Sphere{{50, 0, 0}, 1},
                                    axisBox({0, 0, 0}, {1, 1, 1})};
    const World world = prepareWorld(treeOf(leaves, {kLeaf, kLeaf, kIntersection, kLeaf, kUnion}));
    const auto hit = traceClosest(world, {.origin = {0.75, 3, 0.5}, .direction = {0, -1, 0}});
    REQUIRE(hit);
    CHECK(hit->leaf == 2);
}

TEST_CASE("a gap thinner than a place is closed, a wider one is open") {
    // From 4 away a place is 4 * 2^-18 = 1.5e-5 wide.
    const auto hitsOf = [](double gap) {
        const World world = prepareWorld(
            treeOf({axisBox({0, 0, 0}, {1, 1, 1}), axisBox({1 + gap, 0, 0}, {2, 1, 1})}, {kLeaf, kLeaf, kUnion}));
        const auto hit = traceClosest(world, {.origin = {-3, 0.5, 0.5}, .direction = {1, 0, 0}, .tMax = kInfinite});
        REQUIRE(hit);
        const Ray inside{.origin = {0.5, 0.5, 0.5}, .direction = {1, 0, 0}};
        return traceClosest(world, inside)->t;
    };
    CHECK_THAT(hitsOf(1e-6), WithinAbs(1.5, 1e-12)); // from inside 0.5 away: 1.9e-6 wide
    CHECK_THAT(hitsOf(1e-5), WithinAbs(0.5, 1e-12));
}

TEST_CASE("a ray that leaves coincident faces starts beyond all of them") {
    // Tops that differ by 1e-6, less than a place seen from 2 away (7.6e-6): the lower one is met, being the first
    // leaf's; yet the ray that is reflected must not start below the other.
    const World world = prepareWorld(
        treeOf({axisBox({0, 0, 0}, {1, 1, 1}), axisBox({0, 0, 0}, {1, 1 + 1e-6, 1})}, {kLeaf, kLeaf, kUnion}));
    const Ray down{.origin = {0.5, 3, 0.5}, .direction = {0, -1, 0}};
    const auto hit = traceClosest(world, down);
    REQUIRE(hit);
    CHECK(hit->leaf == 0);
    CHECK_THAT(hit->spread, WithinAbs(1e-6, 1e-14));
    const Surface surface = evaluateSurface(world, down, *hit);
    CHECK(surface.front);
    const dvec3 up = glm::normalize(dvec3(1, 0.1, 0));
    CHECK_FALSE(traceClosest(world, {.origin = leave(surface, up), .direction = up}));
}

TEST_CASE("a shadow ray is blocked by a solid and not by what is cut out of it") {
    const World world =
        prepareWorld(treeOf({axisBox(dvec3(-1), dvec3(1)), endlessCylinder(0, 0.5)}, {kLeaf, kLeaf, kDifference}));
    CHECK(traceShadow(world, {-5, 0, 0}, {5, 0, 0}));
    CHECK_FALSE(traceShadow(world, {-5, 0.6, 0}, {5, 0.6, 0}));
    CHECK(traceShadow(world, {-5, 0.6, 0}, {-1.5, 0.6, 0}));
}

TEST_CASE("shapes without an inside are refused as leaves, and so are invalid programs") {
    CHECK_THROWS_AS(prepareWorld(treeOf({Quad{}}, {kLeaf})), Error);
    CHECK_THROWS_AS(prepareWorld(treeOf({Disk{}}, {kLeaf})), Error);
    Quadric open = axisBox(dvec3(-1), dvec3(1));
    open.capped = false;
    CHECK_THROWS_AS(prepareWorld(treeOf({open}, {kLeaf})), Error);
    CHECK_THROWS_AS(CsgTree(Csg{.firstLeaf = 0, .program = {kLeaf, kUnion}}, {Sphere{}}, {}), Error);
    CHECK_THROWS_AS(CsgTree(Csg{.firstLeaf = 0, .program = {kLeaf, kLeaf}}, {Sphere{}, Sphere{}}, {}), Error);
    CHECK_THROWS_AS(CsgTree(Csg{.firstLeaf = 0, .program = {}}, {}, {}), Error);
    const std::vector<Solid> many(kMostCsgLeaves + 1, Sphere{});
    std::vector<CsgStep> program(many.size(), kLeaf);
    program.insert(program.end(), many.size() - 1, kUnion);
    CHECK_THROWS_AS(CsgTree(Csg{.firstLeaf = 0, .program = program}, many, {}), Error);
}
