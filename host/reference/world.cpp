// Preparing the scene, and the two questions rays ask of it: what is nearest, and is the way free.
#include "reference/world.h"

#include "scene/bounds.h"

#include <algorithm>
#include <memory>
#include <tuple>

namespace hyalite::reference {

namespace {

using MeshTrees = std::vector<std::shared_ptr<const MeshTree>>;

MeshTrees plantTrees(const Scene& scene) {
    MeshTrees trees;
    for (const Mesh& mesh : scene.meshes) {
        trees.push_back(std::make_shared<const MeshTree>(mesh));
    }
    return trees;
}

Geometry makeGeometry(const Object& object, const MeshTrees& trees) {
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        return *sphere;
    }
    if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        return *quad;
    }
    if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
        return Instance{.tree = trees.at(instance->mesh), .map = Affine(instance->objectToWorld)};
    }
    throw Error(ExitCode::BadInput, object.where, "the reference renderer does not know this shape");
}

// Boxes only save time: they are wider than any rounding in what they hold.
Box paddedBox(const Bounds& bounds) {
    const glm::dvec3 farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    const double padding = 0x1p-17 * std::max({farthest.x, farthest.y, farthest.z});
    return {bounds.low - padding, bounds.high + padding};
}

std::optional<ShapeHit> intersect(const Ray& ray, const Geometry& geometry, Wanted wanted) {
    if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
        return intersectSphere(ray, *sphere);
    }
    if (const auto* quad = std::get_if<Quad>(&geometry)) {
        return intersectQuad(ray, *quad);
    }
    return intersectInstance(ray, std::get<Instance>(geometry), wanted);
}

} // namespace

World prepareWorld(const Scene& scene) {
    World world{.camera = makeCameraFrame(scene.camera, scene.file),
                .render = scene.render,
                .initialRadius = initialRadius(scene),
                .materials = scene.materials,
                .objects = scene.objects,
                .geometry = {},
                .lights = makeLights(scene),
                .bvh = {}};
    const MeshTrees trees = plantTrees(scene);
    std::vector<Box> boxes;
    for (const Object& object : scene.objects) {
        world.geometry.push_back(makeGeometry(object, trees));
        boxes.push_back(paddedBox(worldBounds(scene, object)));
    }
    world.bvh = Bvh(boxes);
    return world;
}

std::optional<Hit> traceClosest(const World& world, const Ray& ray) {
    std::optional<Hit> nearest;
    Ray shrinking = ray;
    world.bvh.walk(shrinking, [&](std::uint32_t object) {
        const std::optional<ShapeHit> hit = intersect(shrinking, world.geometry[object], Wanted::Nearest);
        if (hit && (!nearest || std::tuple(hit->t, object) < std::tuple(nearest->t, nearest->object))) {
            nearest = Hit{.t = hit->t, .object = object, .primitive = hit->part, .u = hit->u, .v = hit->v};
            shrinking.tMax = hit->t;
        }
        return true;
    });
    return nearest;
}

bool traceShadow(const World& world, const glm::dvec3& from, const glm::dvec3& to) {
    const double distance = glm::length(to - from);
    Ray ray{.origin = from, .direction = (to - from) / distance, .tMax = distance};
    bool visible = true;
    world.bvh.walk(ray, [&](std::uint32_t object) {
        visible = !intersect(ray, world.geometry[object], Wanted::Any);
        return visible;
    });
    return visible;
}

Surface evaluateSurface(const World& world, const Ray& ray, const Hit& hit) {
    const ShapeHit shapeHit{.t = hit.t, .u = hit.u, .v = hit.v, .part = hit.primitive};
    const SurfacePoint point =
        std::visit([&](const auto& shape) { return surfaceAt(shape, ray, shapeHit); }, world.geometry.at(hit.object));
    const Object& object = world.objects[hit.object];
    Surface surface{};
    surface.position = point.position;
    surface.offset = point.offset;
    surface.front = glm::dot(ray.direction, point.geometricNormal) < 0;
    surface.geometricNormal = surface.front ? point.geometricNormal : -point.geometricNormal;
    surface.normal = surface.front ? point.normal : -point.normal;
    if (surface.front) {
        surface.emission = object.emission;
    }
    if (object.material) {
        surface.material = &world.materials.at(*object.material);
    }
    return surface;
}

glm::dvec3 leave(const Surface& surface, const glm::dvec3& direction) {
    const double side = glm::dot(surface.geometricNormal, direction) >= 0 ? 1.0 : -1.0;
    return surface.position + side * surface.offset * surface.geometricNormal;
}

} // namespace hyalite::reference
