#include "bench/built_in_scenes.h"

#include "bench/mesh_room.h"
#include "scene/import/teapot.h"
#include "scene/model/named_quadrics.h"

#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

namespace hyalite::bench {

namespace {

using glm::dmat4;
using glm::dvec3;

constexpr glm::uvec2 kResolution{768, 768};
enum Materials : std::size_t { kGray, kRed, kMirror, kGlass };

Scene sceneOf(const std::string& name, const dvec3& position, const dvec3& lookAt) {
    Scene scene;
    scene.file = name;
    scene.camera = {.position = position, .lookAt = lookAt, .fov = 60, .resolution = kResolution};
    scene.materials = {{"gray", Diffuse{dvec3(0.7)}},
                       {"red", Diffuse{{0.7, 0.25, 0.2}}},
                       {"mirror", Mirror{dvec3(0.9)}},
                       {"glass", Dielectric{1.5}}};
    return scene;
}

void add(Scene& scene, Shape shape, std::size_t material) {
    scene.objects.push_back({.shape = std::move(shape), .material = material, .emission = dvec3(0), .where = {}});
}

void addLamp(Scene& scene, const Quad& quad, double radiance) {
    scene.objects.push_back({.shape = quad, .material = std::nullopt, .emission = dvec3(radiance), .where = {}});
}

// A floor about the origin and a light above it, facing down.
void addFloorAndLamp(Scene& scene, double size, double height) {
    add(scene, Quad{{-size, 0, size}, {2 * size, 0, 0}, {0, 0, -2 * size}}, kGray);
    addLamp(scene, {{-1, height, -1}, {2, 0, 0}, {0, 0, 2}}, 10);
}

Scene meshRoom() {
    Scene scene = sceneOf("mesh-room", {3.2, 2.2, 3.4}, {-0.6, 1.2, -1});
    scene.meshes = {makeMeshRoom()};
    add(scene, MeshInstance{0}, kGray);
    addLamp(scene, {{-1, 3.8, -1}, {2, 0, 0}, {0, 0, 2}}, 10);
    return scene;
}

Scene teapot() {
    Scene scene = sceneOf("teapot", {0, 3, 7}, {0, 1.4, 0});
    scene.meshes = {makeTeapot(40)};
    add(scene, MeshInstance{0}, kGray);
    addFloorAndLamp(scene, 8, 6);
    return scene;
}

dmat4 placed(const dvec3& at, double turn) {
    return glm::rotate(glm::translate(dmat4(1), at), turn, glm::normalize(dvec3(1, 2, 1)));
}

// Seven by seven solids of four kinds.
Scene quadrics() {
    Scene scene = sceneOf("quadrics", {0, 6, 9}, {0, 0.4, 0});
    for (int i = 0; i < 49; ++i) {
        const int row = i / 7;
        const dvec3 at(1.4 * (i % 7 - 3), 0.7, 1.4 * (row - 3));
        const std::size_t material = i % 5 == 0 ? kMirror : i % 5 == 1 ? kGlass : kRed;
        if (i % 4 == 0) {
            add(scene, Torus{0.4, 0.15, placed(at, i)}, material);
        } else {
            Quadric quadric = i % 4 == 1   ? boxQuadric(dvec3(0.4))
                              : i % 4 == 2 ? cylinderQuadric(0.35, 0.8)
                                           : coneQuadric(0.45, 0, 0.9);
            quadric.objectToWorld = placed(at, i) * quadric.objectToWorld;
            add(scene, quadric, material);
        }
    }
    addFloorAndLamp(scene, 8, 7);
    return scene;
}

// Five by five boxes, each minus one ball and united with another.
Scene csg() {
    Scene scene = sceneOf("csg", {0, 6, 8}, {0, 0.4, 0});
    const auto leaf = [&](Shape shape, std::size_t material) {
        scene.csgLeaves.push_back({.shape = std::move(shape), .material = material, .emission = dvec3(0), .where = {}});
    };
    for (int i = 0; i < 25; ++i) {
        const int row = i / 5;
        const dvec3 at(1.8 * (i % 5 - 2), 0.7, 1.8 * (row - 2));
        Csg solid{.firstLeaf = scene.csgLeaves.size(),
                  .program = {CsgStep::Leaf, CsgStep::Leaf, CsgStep::Difference, CsgStep::Leaf, CsgStep::Union}};
        Quadric box = boxQuadric(dvec3(0.5));
        box.objectToWorld = placed(at, i);
        leaf(box, kRed);
        leaf(Sphere{at + dvec3(0.1, 0.3, 0.3), 0.55}, kGray);
        leaf(Sphere{at - dvec3(0.3, 0.1, 0.2), 0.4}, kGray);
        add(scene, solid, kGray);
    }
    addFloorAndLamp(scene, 8, 7);
    return scene;
}

// A hundred by a hundred instances of one teapot mesh.
Scene instances() {
    Scene scene = sceneOf("instances", {-3, 2.6, 24}, {3, -0.6, 14});
    scene.meshes = {makeTeapot(6)};
    for (int i = 0; i < 10000; ++i) {
        const int row = i / 100;
        const dvec3 at(0.8 * (i % 100 - 50), 0, 0.8 * (row - 80));
        add(scene, MeshInstance{0, glm::scale(placed(at, 0.37 * i), dvec3(0.12))}, i % 2 == 0 ? kGray : kRed);
    }
    addFloorAndLamp(scene, 80, 30);
    return scene;
}

const std::map<std::string, std::function<Scene()>>& makers() {
    static const std::map<std::string, std::function<Scene()>> all = {
        {"mesh-room", meshRoom}, {"teapot", teapot}, {"quadrics", quadrics}, {"csg", csg}, {"instances", instances}};
    return all;
}

} // namespace

const std::vector<std::string>& builtInScenes() {
    static const std::vector<std::string> names = {"mesh-room", "teapot", "quadrics", "csg", "instances"};
    return names;
}

Scene makeBuiltInScene(const std::string& name) {
    return makers().at(name)();
}

} // namespace hyalite::bench
