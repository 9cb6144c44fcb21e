// A scene on both sides: uploaded for the kernels, prepared for their twins. And the scenes that kernel tests share.
#pragma once

#include "reference/world.h"
#include "render/upload/device_scene.h"
#include "render/wavefront/device.h"
#include "support/gpu_fixture.h"
#include "unit/reference/support.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace hyalite::testing {

using glm::dvec3;
using glm::vec3;

struct BothSides {
    Scene scene;
    reference::World world;
    render::Device device{Gpu::shared().context(), Gpu::shared().compiler(), false};
    render::DeviceScene deviceScene;

    explicit BothSides(Scene s)
        : scene(std::move(s)), world(reference::prepareWorld(scene)),
          deviceScene(render::uploadScene(device.context, device.tables, scene)) {}

    // Runs one kernel specialised to the scene and waits for it.
    template <class Arguments>
    void run(const std::string& kernel, const Arguments& arguments, std::uint32_t threads) {
        device.commands.run(Gpu::shared().kernel(kernel, deviceScene.specialization), arguments, threads);
        device.commands.finish();
    }
    template <class T>
    [[nodiscard]] gpu::Array<T> upload(const std::vector<T>& values) const {
        return {device.context, std::span<const T>(values), "test input", gpu::Memory::Host};
    }
    template <class T>
    [[nodiscard]] gpu::Array<T> room(std::size_t count) const {
        return {device.context, count, "test output", gpu::Memory::Host};
    }
    [[nodiscard]] std::uint32_t sceneObject(std::uint32_t deviceObject) const {
        return deviceObject == shared::kNone ? shared::kNone : deviceScene.objectOf[deviceObject];
    }
};

inline shared::Ray toDevice(const reference::Ray& ray) {
    return {ray.origin, std::isfinite(ray.tMax) ? static_cast<float>(ray.tMax) : 3e38F, ray.direction, 0};
}

// What the device's ray says exactly, so that both sides start from the same numbers.
inline reference::Ray toReference(const shared::Ray& ray) {
    return {.origin = ray.origin, .direction = glm::normalize(dvec3(ray.direction)), .tMax = double{ray.tMax}};
}

// Sphere of 2 * rings * rings triangles about the origin, radius 1.
inline Mesh sphereMesh(std::uint32_t rings, bool smooth) {
    Mesh mesh;
    const std::uint32_t sectors = 2 * rings;
    for (std::uint32_t i = 0; i <= rings; ++i) {
        for (std::uint32_t j = 0; j < sectors; ++j) {
            const double theta = std::numbers::pi * i / rings;
            const double phi = 2 * std::numbers::pi * j / sectors;
            mesh.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                        -std::sin(theta) * std::sin(phi));
        }
    }
    for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < sectors; ++j) {
            const std::uint32_t a = i * sectors + j;
            const std::uint32_t b = i * sectors + (j + 1) % sectors;
            if (i > 0) {
                mesh.triangles.emplace_back(a, a + sectors, b);
            }
            if (i + 1 < rings) {
                mesh.triangles.emplace_back(b, a + sectors, b + sectors);
            }
        }
    }
    if (smooth) {
        for (const vec3& p : mesh.positions) {
            mesh.normals.push_back(glm::normalize(p));
        }
    }
    return mesh;
}

// The Cornell box with thirty more spheres and three instances of two meshes, one of them mirrored: more objects than
// are tried one by one, so that the hierarchy over objects is used.
inline Scene crowdedBox() {
    Scene scene = reference::test::cornellBox();
    reference::test::Random random;
    for (std::size_t i = 0; i < 30; ++i) {
        const dvec3 center = random.inCube(0.9);
        reference::test::addObject(scene, Sphere{center, random.between(0.02, 0.1)}, i % scene.materials.size());
    }
    scene.meshes = {sphereMesh(12, true), sphereMesh(5, false)};
    const auto place = [](const dvec3& at, const dvec3& scale, double angle) {
        const glm::dmat4 moved = glm::translate(glm::dmat4(1), at);
        return glm::scale(glm::rotate(moved, angle, glm::normalize(dvec3(1, 2, 3))), scale);
    };
    reference::test::addObject(scene, MeshInstance{0, place({-0.5, 0.4, 0}, dvec3(0.3), 0.7)}, 0);
    reference::test::addObject(scene, MeshInstance{0, place({0.5, 0.3, -0.3}, {0.2, 0.4, -0.1}, 1.9)}, 4);
    reference::test::addObject(scene, MeshInstance{1, place({0, -0.5, -0.5}, dvec3(0.25), 0.2)}, 3);
    return scene;
}

// The Cornell box of coats, metal and frosted glass.
inline Scene roughBox() {
    Scene scene = reference::test::cornellBox();
    scene.materials = {{"white", MetallicRoughness{{0.7, 0.5, 0.3}, 0, 0.4}},
                       {"red", Conductor{{0.2, 0.9, 1.1}, {3.9, 2.4, 2.1}, 0.5}},
                       {"green", MetallicRoughness{{0.2, 0.6, 0.4}, 0.6, 0.8}},
                       {"mirror", Conductor{{1.6, 0.9, 0.5}, {9.2, 6.3, 4.8}, 0}},
                       {"glass", Dielectric{1.5, 0.35}}};
    reference::test::addMaterial(scene, MetallicRoughness{{0.9, 0.2, 0.1}, 0, 0});
    reference::test::addMaterial(scene, Dielectric{0.7, 0.2});
    reference::test::addMaterial(scene, Conductor{dvec3(0.2), dvec3(3), 1});
    reference::test::Random random;
    for (std::size_t i = 0; i < 24; ++i) {
        reference::test::addObject(scene, Sphere{random.inCube(0.9), random.between(0.05, 0.2)}, i % 8);
    }
    scene.meshes = {sphereMesh(12, true)};
    reference::test::addObject(scene, MeshInstance{0, glm::scale(glm::dmat4(1), dvec3(0.3))}, 4);
    scene.lights = {{{0.2, 0.5, 0.1}, {1, 2, 3}}};
    reference::test::addObject(scene, Sphere{{-0.5, 0.5, 0.5}, 0.15}, std::nullopt, {2, 6, 3});
    return scene;
}

inline double distance(const vec3& a, const dvec3& b) {
    return glm::length(dvec3(a) - b);
}

// How ill-conditioned scattering at a hit is: positions that are right to eps give directions right to eps over this.
// A ray that grazes a curved surface loses digits by 1 / cos of its angle to the normal, and a refracted ray that
// leaves along the surface is the root of a small difference.
inline double conditioning(const dvec3& arriving, const dvec3& leaving, const dvec3& normal) {
    return std::abs(glm::dot(arriving, normal) * glm::dot(leaving, normal));
}

} // namespace hyalite::testing
