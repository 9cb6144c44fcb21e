// Prepares the scene, and answers the two ray queries: the nearest hit, and visibility between two points.
#include "reference/world.h"

#include "geometry/specular_targets.h"
#include "reference/lights/shadow.h"
#include "reference/media/start_media.h"
#include "scene/model/bounds.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>

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

Solid makeSolid(const Object& object, const MeshTrees& trees) {
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        return *sphere;
    }
    if (const auto* plane = std::get_if<Plane>(&object.shape)) {
        return *plane;
    }
    if (const auto* quadric = std::get_if<Quadric>(&object.shape)) {
        return WorldQuadric(*quadric);
    }
    if (const auto* torus = std::get_if<Torus>(&object.shape)) {
        return WorldTorus(*torus);
    }
    if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
        return Instance{.tree = trees.at(instance->mesh), .map = Affine(instance->objectToWorld)};
    }
    throw Error(ExitCode::BadInput, object.where, "this shape has no inside", "a CSG tree needs closed shapes");
}

CsgTree makeTree(const Scene& scene, const Object& object, const MeshTrees& trees) {
    const Csg& csg = std::get<Csg>(object.shape);
    std::vector<Solid> leaves;
    for (const CsgStep step : csg.program) {
        if (step == CsgStep::Leaf) {
            const Object& leaf = scene.csgLeaves.at(csg.firstLeaf + leaves.size());
            leaves.push_back(makeSolid(leaf, trees));
            const auto* quadric = std::get_if<WorldQuadric>(&leaves.back());
            if (quadric != nullptr && quadric->open) {
                throw Error(ExitCode::BadInput, leaf.where, "this quadric is open, and has no inside", "cap it");
            }
        }
    }
    return {csg, std::move(leaves), object.where, csgExtent(scene, csg)};
}

Geometry makeGeometry(const Scene& scene, const Object& object, const MeshTrees& trees) {
    if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        return *quad;
    }
    if (const auto* disk = std::get_if<Disk>(&object.shape)) {
        return *disk;
    }
    if (std::holds_alternative<Csg>(object.shape)) {
        return makeTree(scene, object, trees);
    }
    return makeSolid(object, trees);
}

// Boxes only save time: the padding exceeds any rounding in their contents.
Box paddedBox(const Bounds& bounds) {
    const glm::dvec3 farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    const double padding = 0x1p-17 * std::max({farthest.x, farthest.y, farthest.z});
    return {bounds.low - padding, bounds.high + padding};
}

// The hit of one object.
std::optional<Hit> intersect(const World& world, std::uint32_t object, const Ray& ray, Wanted wanted) {
    const Geometry& geometry = world.geometry[object];
    if (const auto* tree = std::get_if<CsgTree>(&geometry)) {
        const std::optional<CsgHit> hit = intersectCsg(ray, *tree);
        if (!hit) {
            return std::nullopt;
        }
        return Hit{.t = hit->at.t,
                   .object = object,
                   .primitive = hit->at.part,
                   .u = hit->at.u,
                   .v = hit->at.v,
                   .leaf = static_cast<std::uint32_t>(tree->firstLeaf + hit->leaf),
                   .spread = hit->spread};
    }
    std::optional<ShapeHit> hit;
    if (const auto* solid = std::get_if<Solid>(&geometry)) {
        hit = intersectSolid(ray, *solid, wanted);
    } else if (const auto* quad = std::get_if<Quad>(&geometry)) {
        hit = intersectQuad(ray, *quad);
    } else {
        hit = intersectDisk(ray, std::get<Disk>(geometry));
    }
    if (!hit) {
        return std::nullopt;
    }
    return Hit{.t = hit->t, .object = object, .primitive = hit->part, .u = hit->u, .v = hit->v};
}

// Calls visit(object) for every object that the ray may meet, until it returns false; it may lower ray.tMax.
template <typename Visit>
void visitObjects(const World& world, Ray& ray, Visit&& visit) {
    for (const std::uint32_t object : world.unbounded) {
        if (!visit(object)) {
            return;
        }
    }
    world.bvh.walk(ray, [&](std::uint32_t item) { return visit(world.bounded[item]); });
}

// A point on a CSG solid: the solid's outside may be the leaf's inside, and the ray offset clears all faces that
// coincide there.
SurfacePoint surfaceOfTree(const CsgTree& tree, const Ray& ray, const Hit& hit, const ShapeHit& onLeaf) {
    const CsgTree::Leaf& leaf = tree.leaves.at(hit.leaf - tree.firstLeaf);
    SurfacePoint point = surfaceOf(leaf.solid, ray, onLeaf);
    if (leaf.reversed) {
        point.geometricNormal = -point.geometricNormal;
        point.normal = -point.normal;
    }
    point.offset += hit.spread * std::abs(glm::dot(ray.direction, point.geometricNormal));
    return point;
}

SurfacePoint surfaceOf(const Geometry& geometry, const Ray& ray, const Hit& hit) {
    const ShapeHit onShape{.t = hit.t, .u = hit.u, .v = hit.v, .part = hit.primitive};
    if (const auto* tree = std::get_if<CsgTree>(&geometry)) {
        return surfaceOfTree(*tree, ray, hit, onShape);
    }
    if (const auto* solid = std::get_if<Solid>(&geometry)) {
        return surfaceOf(*solid, ray, onShape);
    }
    if (const auto* quad = std::get_if<Quad>(&geometry)) {
        return surfaceAt(*quad, ray, onShape);
    }
    return surfaceAt(std::get<Disk>(geometry), ray, onShape);
}

} // namespace

World prepareWorld(const Scene& scene) {
    World world{.camera = makeCameraFrame(scene.camera, scene.file),
                .cameraMedia = {},
                .render = scene.render,
                .cameraPaths = integratorNamed(scene.render.integrator).cameraPaths,
                .origin = scene.origin,
                .sceneRadius = sceneRadius(scene),
                .surfaceError = surfaceError(scene),
                .pixelFootprint = pixelFootprint(scene.camera),
                .globalRadius = globalSearchRadius(scene),
                .causticRadius = causticSearchRadius(scene),
                .targets = specularTargets(scene),
                .textures = scene.textures,
                .materials = scene.materials,
                .objects = scene.objects,
                .csgLeaves = scene.csgLeaves,
                .geometry = {},
                .lights = makeLights(scene),
                .lightTree = buildLightTree(lightExtents(scene)),
                .neighbors = {},
                .bounded = {},
                .unbounded = {},
                .bvh = {}};
    const MeshTrees trees = plantTrees(scene);
    std::vector<Box> boxes;
    for (const Object& object : scene.objects) {
        const auto index = static_cast<std::uint32_t>(world.geometry.size());
        world.geometry.push_back(makeGeometry(scene, object, trees));
        const Bounds bounds = worldBounds(scene, object);
        if (isFinite(bounds)) {
            world.bounded.push_back(index);
            boxes.push_back(paddedBox(bounds));
        } else {
            world.unbounded.push_back(index);
        }
    }
    world.bvh = Bvh(boxes);
    world.neighbors = touchingObjects(scene, world);
    world.hasStraightGlass = hasStraightGlass(scene.materials) || !world.neighbors.empty();
    world.indicesFromMedia = hasPriorities(scene.materials) || !world.neighbors.empty();
    StartMedia start = startMedia(scene, world);
    world.cameraMedia = start.camera;
    for (std::size_t i = 0; i < world.lights.size(); ++i) {
        world.lights[i].media = start.lights.at(i);
    }
    return world;
}

std::optional<Hit> traceClosest(const World& world, const Ray& ray) {
    std::optional<Hit> nearest;
    Ray shrinking = ray;
    visitObjects(world, shrinking, [&](std::uint32_t object) {
        const std::optional<Hit> hit = intersect(world, object, shrinking, Wanted::Nearest);
        if (hit && (!nearest || std::tie(hit->t, hit->object) < std::tie(nearest->t, nearest->object))) {
            nearest = hit;
            shrinking.tMax = hit->t;
        }
        return true;
    });
    return nearest;
}

std::optional<Hit> traceObject(const World& world, std::uint32_t object, const Ray& ray) {
    return intersect(world, object, ray, Wanted::Nearest);
}

bool traceShadow(const World& world, const glm::dvec3& from, const glm::dvec3& to) {
    const double distance = glm::length(to - from);
    Ray ray{.origin = from, .direction = (to - from) / distance, .tMax = distance};
    bool visible = true;
    visitObjects(world, ray, [&](std::uint32_t object) {
        visible = !intersect(world, object, ray, Wanted::Any);
        return visible;
    });
    return visible;
}

Surface evaluateSurface(const World& world, const Ray& ray, const Hit& hit) {
    const SurfacePoint point = surfaceOf(world.geometry.at(hit.object), ray, hit);
    const Object& object = world.objects[hit.object];
    Surface surface{};
    surface.position = point.position;
    surface.offset = point.offset;
    surface.uv = point.uv;
    surface.front = glm::dot(ray.direction, point.geometricNormal) < 0;
    surface.geometricNormal = surface.front ? point.geometricNormal : -point.geometricNormal;
    surface.normal = surface.front ? point.normal : -point.normal;
    if (surface.front) {
        surface.emission = object.emission;
    }
    surface.quad = std::get_if<Quad>(&object.shape);
    surface.disk = std::get_if<Disk>(&object.shape);
    const auto& material = hit.leaf == kNoLeaf ? object.material : world.csgLeaves.at(hit.leaf).material;
    if (material) {
        surface.material = &world.materials.at(*material);
    }
    return surface;
}

std::size_t materialNumber(const World& world, const Surface& surface) {
    return static_cast<std::size_t>(surface.material - world.materials.data());
}

bool isInside(const World& world, std::uint32_t object, const glm::dvec3& point) {
    const Geometry& geometry = world.geometry.at(object);
    if (const auto* tree = std::get_if<CsgTree>(&geometry)) {
        return isInside(*tree, point);
    }
    const auto* solid = std::get_if<Solid>(&geometry);
    return solid != nullptr && isInsideOf(*solid, point);
}

glm::dvec3 leave(const Surface& surface, const glm::dvec3& direction) {
    const double side = glm::dot(surface.geometricNormal, direction) >= 0 ? 1.0 : -1.0;
    return surface.position + side * surface.offset * surface.geometricNormal;
}

} // namespace hyalite::reference
