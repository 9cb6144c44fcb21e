// Shared by the tests of the reference: comparisons of vectors, plain random numbers, and small scenes.
#pragma once

#include "reference/lib/sampling.h"
#include "scene/model/scene.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <random>

namespace hyalite::reference::test {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using glm::dvec2;
using glm::dvec3;

inline void checkNear(const dvec3& actual, const dvec3& expected, double tolerance) {
    INFO("actual " << actual.x << ' ' << actual.y << ' ' << actual.z);
    INFO("expected " << expected.x << ' ' << expected.y << ' ' << expected.z);
    CHECK(glm::length(actual - expected) <= tolerance);
}

// Test input only; the same on every machine.
class Random {
public:
    double unit() { return toUnit(static_cast<std::uint32_t>(engine_())); }
    double between(double low, double high) { return low + (high - low) * unit(); }
    dvec3 inCube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
    dvec3 direction() { return uniformSphere({unit(), unit()}); }

private:
    std::mt19937 engine_{12345};
};

// One pixel, so narrow that all its rays are the axis from position to target (to 1e-4 rad).
inline Scene onePixel(const dvec3& position, const dvec3& target, std::string_view integrator) {
    Scene scene;
    scene.camera = {.position = position, .lookAt = target, .up = {0, 1, 0}, .fov = 0.01, .resolution = {1, 1}};
    if (std::abs(glm::normalize(target - position).y) > 0.9) {
        scene.camera.up = {0, 0, 1};
    }
    scene.render.integrator = integrator;
    scene.render.passes = 1;
    scene.render.photons = 1;
    scene.render.radius = 0.1;
    return scene;
}

inline std::size_t addMaterial(Scene& scene, const MaterialModel& model) {
    scene.materials.push_back({.name = {}, .model = model});
    return scene.materials.size() - 1;
}

inline void addObject(Scene& scene, const Shape& shape, std::optional<std::size_t> material,
                      const dvec3& emission = dvec3(0)) {
    scene.objects.push_back({.shape = shape, .material = material, .emission = emission, .where = {}});
}

// The default scene's box: glass and mirror sphere, square light, open towards the camera.
inline Scene cornellBox() {
    Scene scene;
    scene.camera = {.position = {0, 0, 3.9}, .lookAt = {0, 0, 0}, .up = {0, 1, 0}, .fov = 39.3, .resolution = {16, 16}};
    scene.render.integrator = "ppm";
    scene.render.maxDepth = 12;
    scene.render.passes = 2;
    scene.render.photons = 4000;
    scene.render.photonMap.causticPhotons = 2000;
    const std::size_t white = addMaterial(scene, Diffuse{{0.725, 0.71, 0.68}});
    const std::size_t red = addMaterial(scene, Diffuse{{0.63, 0.065, 0.05}});
    const std::size_t green = addMaterial(scene, Diffuse{{0.14, 0.45, 0.091}});
    const std::size_t mirror = addMaterial(scene, Mirror{dvec3(0.9)});
    const std::size_t glass = addMaterial(scene, Dielectric{1.5});
    addObject(scene, Quad{{-1, -1, -1}, {0, 0, 2}, {2, 0, 0}}, white); // floor
    addObject(scene, Quad{{-1, 1, -1}, {2, 0, 0}, {0, 0, 2}}, white);  // ceiling
    addObject(scene, Quad{{-1, -1, -1}, {2, 0, 0}, {0, 2, 0}}, white); // back
    addObject(scene, Quad{{-1, -1, -1}, {0, 2, 0}, {0, 0, 2}}, red);   // left
    addObject(scene, Quad{{1, -1, -1}, {0, 0, 2}, {0, 2, 0}}, green);  // right
    addObject(scene, Quad{{-0.25, 0.999, -0.25}, {0.5, 0, 0}, {0, 0, 0.5}}, std::nullopt, {18.4, 15.6, 8});
    addObject(scene, Sphere{{-0.42, -0.67, -0.28}, 0.33}, mirror);
    addObject(scene, Sphere{{0.42, -0.67, 0.25}, 0.33}, glass);
    return scene;
}

} // namespace hyalite::reference::test
