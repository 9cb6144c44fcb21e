// See recentre.h.
#include "scene/model/recentre.h"

#include "scene/model/bounds.h"
#include "scene/model/quadric.h"

#include <algorithm>
#include <cmath>

namespace hyalite {
namespace {

using glm::dvec3;

// The first of ..., 0.5, 1, 2, 5, 10, 20, ... that is at least `value`: survey coordinates are offset by such numbers,
// so that a moved scene has the coordinates of one that was never offset.
double roundNumber(double value) {
    double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= value) {
            return factor * power;
        }
    }
    return 10 * power;
}

void moveShape(Shape& shape, const dvec3& by) {
    if (auto* sphere = std::get_if<Sphere>(&shape)) {
        sphere->center += by;
    } else if (auto* quad = std::get_if<Quad>(&shape)) {
        quad->corner += by;
    } else if (auto* disk = std::get_if<Disk>(&shape)) {
        disk->center += by;
    } else if (auto* plane = std::get_if<Plane>(&shape)) {
        plane->point += by;
    } else if (auto* quadric = std::get_if<Quadric>(&shape)) {
        quadric->objectToWorld[3] += glm::dvec4(by, 0);
    } else if (auto* torus = std::get_if<Torus>(&shape)) {
        torus->objectToWorld[3] += glm::dvec4(by, 0);
    } else if (auto* instance = std::get_if<MeshInstance>(&shape)) {
        instance->objectToWorld[3] += glm::dvec4(by, 0);
    } // a Csg is moved by its leaves
}

void move(Scene& scene, const dvec3& by) {
    scene.camera.position += by;
    scene.camera.lookAt += by;
    for (PointLight& light : scene.lights) {
        light.position += by;
    }
    for (SpotLight& spot : scene.spots) {
        spot.position += by;
    }
    for (DirectionalLight& directional : scene.directionals) {
        if (directional.beam) {
            directional.beam->center += by;
        }
    }
    for (Object& object : scene.objects) {
        moveShape(object.shape, by);
    }
    for (Object& leaf : scene.csgLeaves) {
        moveShape(leaf.shape, by);
    }
}

} // namespace

dvec3 originNear(const dvec3& center, double extent) {
    constexpr double kExtents = 16;
    const double farthest = std::max({std::abs(center.x), std::abs(center.y), std::abs(center.z)});
    if (!(extent > 0) || !(farthest > extent)) {
        return dvec3(0);
    }
    const double step = roundNumber(kExtents * extent);
    dvec3 origin(0);
    for (int axis = 0; axis < 3; ++axis) {
        origin[axis] = step * std::trunc(center[axis] / step + std::copysign(0.5, center[axis]));
    }
    return origin;
}

void recentre(Scene& scene) {
    const Camera& camera = scene.camera;
    const Bounds box = sceneBounds(scene);
    const double reach = glm::length(camera.lookAt - camera.position);
    const double size = glm::length(box.high - box.low) / 2;
    const dvec3 origin =
        originNear(glm::clamp(camera.position, box.low, box.high), size > 0 ? std::min(size, reach) : reach);
    if (origin != dvec3(0)) {
        move(scene, -origin);
        findMeshBounds(scene);
        scene.origin += origin;
    }
}

Camera inWorld(const Camera& camera, const Scene& scene) {
    Camera moved = camera;
    moved.position += scene.origin;
    moved.lookAt += scene.origin;
    return moved;
}

Camera inScene(const Camera& camera, const Scene& scene) {
    Camera moved = camera;
    moved.position -= scene.origin;
    moved.lookAt -= scene.origin;
    return moved;
}

} // namespace hyalite
