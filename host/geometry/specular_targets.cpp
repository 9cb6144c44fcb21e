#include "geometry/specular_targets.h"

#include "scene/model/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hyalite {

namespace {

// Above this many vertices in all instances, a box stands for each instance.
constexpr std::size_t kMostVertices = 4'000'000;

// Spheres are enlarged by this factor, because kernels know them and their contents only to float rounding.
constexpr double kMargin = 1e-5;

bool isSpecular(const Scene& scene, const std::optional<std::size_t>& material) {
    return material && scene.materials.at(*material).model.type != shared::kMaterialDiffuse;
}

bool isSpecular(const Scene& scene, const Object& object) {
    const auto* csg = std::get_if<Csg>(&object.shape);
    if (csg == nullptr) {
        return isSpecular(scene, object.material);
    }
    std::size_t leaf = csg->firstLeaf;
    return std::ranges::any_of(csg->program, [&](CsgStep step) {
        return step == CsgStep::Leaf && isSpecular(scene, scene.csgLeaves.at(leaf++).material);
    });
}

BoundingSphere aroundBox(const Bounds& box) {
    if (!isFinite(box)) {
        return {.center = glm::dvec3(0), .radius = std::numeric_limits<double>::infinity()};
    }
    return {.center = (box.low + box.high) / 2.0, .radius = glm::length(box.high - box.low) / 2};
}

BoundingSphere aroundMesh(const Mesh& mesh, const glm::dmat4& objectToWorld) {
    std::vector<glm::vec3> points;
    points.reserve(mesh.positions.size());
    for (const glm::vec3& p : mesh.positions) {
        points.emplace_back(objectToWorld * glm::dvec4(p, 1));
    }
    return boundingSphere(points);
}

BoundingSphere around(const BoundingSphere& a, const BoundingSphere& b) {
    const glm::dvec3 offset = b.center - a.center;
    const double distance = glm::length(offset);
    if (!(distance + b.radius > a.radius)) {
        return a;
    }
    if (!(distance + a.radius > b.radius)) {
        return b;
    }
    const double radius = (distance + a.radius + b.radius) / 2;
    return {.center = a.center + offset * ((radius - a.radius) / distance), .radius = radius};
}

// Splits the spheres into `parts` groups of neighbours, halving along the axis on which their centres differ most.
void group(std::span<BoundingSphere> spheres, std::size_t parts, std::vector<BoundingSphere>& groups) {
    if (parts == 1 || spheres.size() == 1) {
        BoundingSphere all = spheres.front();
        for (const BoundingSphere& sphere : spheres.subspan(1)) {
            all = around(all, sphere);
        }
        groups.push_back(all);
        return;
    }
    Bounds box;
    for (const BoundingSphere& sphere : spheres) {
        box.add(sphere.center);
    }
    const glm::dvec3 extent = box.high - box.low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    std::ranges::stable_sort(spheres, {}, [axis](const BoundingSphere& s) { return s.center[axis]; });
    group(spheres.first(spheres.size() / 2), parts / 2, groups);
    group(spheres.subspan(spheres.size() / 2), parts - parts / 2, groups);
}

} // namespace

std::vector<BoundingSphere> specularTargets(const Scene& scene) {
    std::vector<const Object*> objects;
    std::size_t vertices = 0;
    for (const Object& object : scene.objects) {
        if (isSpecular(scene, object)) {
            objects.push_back(&object);
            const auto* instance = std::get_if<MeshInstance>(&object.shape);
            vertices += instance != nullptr ? scene.meshes.at(instance->mesh).positions.size() : 0;
        }
    }
    std::vector<BoundingSphere> bounded;
    std::vector<BoundingSphere> targets;
    for (const Object* object : objects) {
        BoundingSphere sphere;
        const auto* instance = std::get_if<MeshInstance>(&object->shape);
        if (const auto* ball = std::get_if<Sphere>(&object->shape)) {
            sphere = {.center = ball->center, .radius = ball->radius};
        } else if (instance != nullptr && vertices <= kMostVertices) {
            sphere = aroundMesh(scene.meshes.at(instance->mesh), instance->objectToWorld);
        } else {
            sphere = aroundBox(worldBounds(scene, *object));
        }
        sphere.radius *= 1 + kMargin;
        (std::isfinite(sphere.radius) ? bounded : targets).push_back(sphere);
    }
    if (!targets.empty()) {
        return {targets.front()}; // unbounded: aiming gains nothing
    }
    if (!bounded.empty()) {
        group(bounded, std::min(kMostTargets, bounded.size()), targets);
    }
    return targets;
}

} // namespace hyalite
