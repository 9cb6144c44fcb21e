// Scenes and meshes far from the origin: what is moved, by how much, and what stays in world coordinates.
#include "unit/scene/scene_test_support.h"

#include "scene/import/mesh_import.h"
#include "scene/model/bounds.h"
#include "scene/model/recentre.h"
#include "scene/yaml/settings.h"

#include <array>

using namespace hyalite;
using namespace hyalite::test;
using glm::dvec3;

TEST_CASE("the origin is a multiple of a round number of sixteen extents, and zero within eight") {
    // 16 * 3 = 48: steps of 50. 1010 / 50 = 20.2, -24.9 rounds to 0, 25.1 to 50.
    CHECK(originNear({1010, -24.9, 25.1}, 3) == dvec3(1000, 0, 50));
    CHECK(originNear({23.9, -24, 24}, 3) == dvec3(0));
    // 16 * 0.02 = 0.32: steps of 0.5
    CHECK(originNear({0, 1e6 + 0.3, 0}, 0.02) == dvec3(0, 1e6 + 0.5, 0));
    CHECK(originNear({5, 6, 7}, 0) == dvec3(0)); // a single point: nothing to resolve
}

TEST_CASE("a far scene is moved near zero, with its camera, lights, shapes and leaves") {
    TemporaryFolder folder;
    const Scene scene = loadScene(folder.write("scene.yaml", R"(hyalite: 1
camera: {position: [100001, -200000, 3], look_at: [100000, -200000, 0]}
materials: {m: {type: diffuse}}
lights:
  - {type: point, position: [100000.5, -200000, 1], intensity: 1}
  - {type: spot, position: [100000, -199999.25, 1], direction: [0, -1, 0], intensity: 1}
  - {type: directional, direction: [0, -1, 0], irradiance: 1, center: [100000, -199998, 0], radius: 1}
objects:
  - {shape: {type: sphere, center: [100000.125, -200000, 0], radius: 1}, material: m}
  - {shape: {type: quad, corner: [99999, -200001, -1], edges: [[2, 0, 0], [0, 0, -2]]}, material: m}
  - {shape: {type: disk, center: [100000, -200001, 0.5], normal: [0, 1, 0], radius: 1}, material: m}
  - {shape: {type: plane, point: [100000, -200002, 0], normal: [0, 1, 0]}, material: m}
  - {shape: {type: box, min: [99999.5, -200000.5, -0.5], max: [100000.5, -199999.5, 0.5]}, material: m}
  - {shape: {type: torus, major: 1, minor: 0.25}, material: m, transform: [{translate: [100000, -200000.25, 0]}]}
  - shape:
      type: csg
      op: union
      left: {type: sphere, center: [100000, -200000, 0.5], radius: 0.5}
      right: {type: sphere, center: [100000, -200000, 0.75], radius: 0.5}
    material: m
)"));
    CHECK(scene.origin == dvec3(100000, -200000, 0));
    CHECK(scene.camera.position == dvec3(1, 0, 3));
    CHECK(scene.camera.lookAt == dvec3(0));
    CHECK(scene.lights.at(0).position == dvec3(0.5, 0, 1));
    CHECK(scene.spots.at(0).position == dvec3(0, 0.75, 1));
    CHECK(scene.directionals.at(0).beam.value().center == dvec3(0, 2, 0));
    CHECK(std::get<Sphere>(scene.objects.at(0).shape).center == dvec3(0.125, 0, 0));
    CHECK(std::get<Quad>(scene.objects.at(1).shape).corner == dvec3(-1, -1, -1));
    CHECK(std::get<Disk>(scene.objects.at(2).shape).center == dvec3(0, -1, 0.5));
    CHECK(std::get<Plane>(scene.objects.at(3).shape).point == dvec3(0, -2, 0));
    CHECK(worldBounds(scene, scene.objects.at(4)).high == dvec3(0.5));
    CHECK(dvec3(std::get<Torus>(scene.objects.at(5).shape).objectToWorld[3]) == dvec3(0, -0.25, 0));
    CHECK(std::get<Sphere>(scene.csgLeaves.at(0).shape).center == dvec3(0, 0, 0.5));
    CHECK(std::get<Sphere>(scene.csgLeaves.at(1).shape).center == dvec3(0, 0, 0.75));

    // Settings are in world coordinates
    Scene seen = scene;
    applySetting(seen, "camera.position", "[100004, -200003, 2]", "--set");
    CHECK(seen.camera.position == dvec3(4, -3, 2));
    CHECK(seen.camera.lookAt == dvec3(0));
    CHECK(inWorld(seen.camera, seen).position == dvec3(100004, -200003, 2));
}

TEST_CASE("the vertices of a far mesh keep the digits that tell them apart") {
    // 0.001 m at 4 000 km: a float there resolves 0.25 m. Every reader subtracts before it rounds.
    const std::string obj = "v 4000000 5000000 100\nv 4000000.001 5000000 100\nv 4000000 5000000.002 100\nf 1 2 3\n";
    const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                            "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                            "4000000 5000000 100\n4000000.001 5000000 100\n4000000 5000000.002 100\n3 0 1 2\n";
    const std::string stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 4000000 5000000 100\n"
                            "vertex 4000000.001 5000000 100\nvertex 4000000 5000000.002 100\nendloop\nendfacet\n"
                            "endsolid a\n";
    for (const Mesh& mesh : {parseObj(obj, "a.obj"), parsePly(ply, "a.ply"), parseStl(stl, "a.stl")}) {
        INFO(mesh.file);
        REQUIRE(mesh.positions.size() == 3);
        const std::array<dvec3, 3> corners{dvec3(4e6, 5e6, 100), {4e6 + 0.001, 5e6, 100}, {4e6, 5e6 + 0.002, 100}};
        for (std::size_t i = 0; i < 3; ++i) {
            // Doubles resolve 1e-9 m there
            CHECK(glm::length(mesh.origin + dvec3(mesh.positions[i]) - corners.at(i)) < 2e-9);
        }
    }
    // An object in the scene, and one whose transform undoes the offset
    TemporaryFolder folder;
    folder.write("a.obj", obj);
    const Scene scene = loadScene(folder.write("scene.yaml", R"(hyalite: 1
camera: {position: [0.0005, 0.001, 0.003], look_at: [0, 0, 0]}
materials: {m: {type: diffuse}}
lights: [{type: environment, radiance: 1}]
objects: [{shape: {type: mesh, file: a.obj}, material: m, transform: [{translate: [-4000000, -5000000, -100]}]}]
)"));
    const Bounds box = worldBounds(scene, scene.objects.at(0));
    CHECK(glm::length(box.low) < 2e-9);
    CHECK(glm::length(box.high - dvec3(0.001, 0.002, 0)) < 2e-9);
}
