// The spheres at which caustic photons are aimed.
#include "geometry/specular_targets.h"

#include "unit/reference/support.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace hyalite::reference::test {

namespace {

bool holds(const std::vector<BoundingSphere>& spheres, const dvec3& point) {
    return std::ranges::any_of(spheres,
                               [&](const BoundingSphere& s) { return glm::length(point - s.center) <= s.radius; });
}

} // namespace

TEST_CASE("everything specular has a target, and nothing else") {
    Scene scene;
    CHECK(specularTargets(scene).empty());
    const std::size_t gray = addMaterial(scene, Diffuse{});
    const std::size_t mirror = addMaterial(scene, Mirror{});
    const std::size_t glass = addMaterial(scene, Dielectric{});
    addObject(scene, Sphere{{9, 9, 9}, 1}, gray);
    addObject(scene, Sphere{{1, 2, 3}, 0.5}, glass);
    addObject(scene, Disk{{-4, 0, 0}, {0.3, 0, 0}, {0, 0, 0.2}}, mirror);
    const std::vector<BoundingSphere> targets = specularTargets(scene);
    REQUIRE(targets.size() == 2);
    const auto [disk, ball] =
        targets[0].radius < targets[1].radius ? std::pair(targets[0], targets[1]) : std::pair(targets[1], targets[0]);
    checkNear(ball.center, {1, 2, 3}, 1e-12);
    CHECK_THAT(ball.radius, WithinRel(0.5, 2e-5)); // a little larger, for the kernels' rounding
    CHECK(ball.radius > 0.5);
    CHECK(disk.radius < 0.37); // half the diagonal of its box: (0.3^2 + 0.2^2)^(1/2)
    CHECK(holds({disk}, {-3.7, 0, 0}));
}

TEST_CASE("a mesh has the sphere around its transformed vertices") {
    Scene scene;
    const std::size_t glass = addMaterial(scene, Dielectric{});
    Mesh mesh;
    Random random;
    for (int i = 0; i < 300; ++i) {
        mesh.positions.emplace_back(random.inCube(1));
    }
    scene.meshes = {mesh};
    const glm::dmat4 map = glm::scale(glm::translate(glm::dmat4(1), dvec3(5, 6, 7)), dvec3(2, 0.1, 0.3));
    addObject(scene, MeshInstance{0, map}, glass);
    const std::vector<BoundingSphere> targets = specularTargets(scene);
    REQUIRE(targets.size() == 1);
    double farthest = 0;
    for (const glm::vec3& p : mesh.positions) {
        const dvec3 world = map * glm::dvec4(p, 1);
        CHECK(holds(targets, world));
        farthest = std::max(farthest, glm::length(world - dvec3(5, 6, 7)));
    }
    CHECK(targets[0].radius < 1.2 * farthest); // no larger than asked of bounding spheres
}

TEST_CASE("a CSG tree with one specular leaf is a target") {
    Scene scene;
    const std::size_t gray = addMaterial(scene, Diffuse{});
    const std::size_t glass = addMaterial(scene, Dielectric{});
    scene.csgLeaves = {{.shape = Sphere{{0, 0, 0}, 1}, .material = gray, .where = {}},
                       {.shape = Sphere{{1, 0, 0}, 1}, .material = gray, .where = {}}};
    addObject(scene, Csg{0, {CsgStep::Leaf, CsgStep::Leaf, CsgStep::Union}}, gray);
    CHECK(specularTargets(scene).empty());
    scene.csgLeaves[1].material = glass;
    const std::vector<BoundingSphere> targets = specularTargets(scene);
    REQUIRE(targets.size() == 1);
    CHECK(holds(targets, {-1, 0, 0}));
    CHECK(holds(targets, {2, 0, 0}));
}

TEST_CASE("a specular plane is unbounded: everything is a target") {
    Scene scene;
    const std::size_t mirror = addMaterial(scene, Mirror{});
    addObject(scene, Sphere{{1, 2, 3}, 0.5}, mirror);
    addObject(scene, Plane{}, mirror);
    const std::vector<BoundingSphere> targets = specularTargets(scene);
    REQUIRE(targets.size() == 1);
    CHECK(std::isinf(targets[0].radius));
}

TEST_CASE("many objects share targets, and all are covered") {
    Scene scene;
    const std::size_t mirror = addMaterial(scene, Mirror{});
    Random random;
    std::vector<Sphere> spheres;
    for (int i = 0; i < 1000; ++i) {
        spheres.push_back({random.inCube(10), random.between(0.01, 0.3)});
        addObject(scene, spheres.back(), mirror);
    }
    const std::vector<BoundingSphere> targets = specularTargets(scene);
    CHECK(targets.size() <= kMostTargets);
    CHECK(targets.size() > kMostTargets / 2);
    for (const Sphere& sphere : spheres) {
        CHECK(std::ranges::any_of(targets, [&](const BoundingSphere& target) {
            return glm::length(sphere.center - target.center) + sphere.radius <= target.radius * (1 + 1e-12);
        }));
    }
}

} // namespace hyalite::reference::test
