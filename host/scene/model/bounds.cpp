// See bounds.h.
#include "scene/model/bounds.h"

#include "base/parallel.h"
#include "scene/model/mesh_extent.h"
#include "scene/model/quadric.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hyalite {
namespace {

template <class OneShape>
Bounds shapeBounds(const Scene& /*scene*/, const OneShape& shape) {
    return worldBounds(shape);
}

Bounds shapeBounds(const Scene& /*scene*/, const Plane& plane) {
    Bounds box = Bounds::everything();
    for (int axis = 0; axis < 3; ++axis) { // a plane across an axis has no extent along it
        if (std::abs(plane.normal[axis]) == 1) {
            box.low[axis] = plane.point[axis];
            box.high[axis] = plane.point[axis];
        }
    }
    return box;
}

Bounds shapeBounds(const Scene& scene, const MeshInstance& instance) {
    return instance.bounds ? *instance.bounds : meshBounds(scene.meshes[instance.mesh], instance.objectToWorld);
}

// Bounds of the leaf as a solid: a plane is the half-space behind it.
Bounds leafBounds(const Scene& scene, const Object& leaf) {
    const auto* plane = std::get_if<Plane>(&leaf.shape);
    if (plane == nullptr) {
        return worldBounds(scene, leaf);
    }
    Bounds box = Bounds::everything();
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(plane->normal[axis]) == 1) {
            (plane->normal[axis] > 0 ? box.high : box.low)[axis] = plane->point[axis];
        }
    }
    return box;
}

Bounds shapeBounds(const Scene& scene, const Csg& csg) {
    std::vector<Bounds> stack;
    std::size_t leaf = csg.firstLeaf;
    for (const CsgStep step : csg.program) {
        if (step == CsgStep::Leaf) {
            stack.push_back(leafBounds(scene, scene.csgLeaves[leaf++]));
            continue;
        }
        const Bounds right = stack.back();
        stack.pop_back();
        Bounds& left = stack.back();
        if (step == CsgStep::Union) {
            left = {glm::min(left.low, right.low), glm::max(left.high, right.high)};
        } else if (step == CsgStep::Intersection) {
            left = intersection(left, right);
        }
    }
    return stack.back();
}

} // namespace

bool isFinite(const Bounds& box) {
    return std::isfinite(glm::dot(box.low, glm::dvec3(1))) && std::isfinite(glm::dot(box.high, glm::dvec3(1)));
}

CsgExtent csgExtent(const Scene& scene, const Csg& csg) {
    CsgExtent extent;
    const Bounds box = shapeBounds(scene, csg);
    if (isFinite(box) && !isEmpty(box)) {
        extent.center = 0.5 * (box.low + box.high);
        extent.radius = 0.5 * glm::length(box.high - box.low);
    }
    for (std::size_t i = 0; i < (csg.program.size() + 1) / 2; ++i) {
        const Object& leaf = scene.csgLeaves[csg.firstLeaf + i];
        if (std::holds_alternative<Torus>(leaf.shape) || std::holds_alternative<MeshInstance>(leaf.shape)) {
            const Bounds bounds = worldBounds(scene, leaf);
            const glm::dvec3 farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
            extent.reach = std::max({extent.reach, farthest.x, farthest.y, farthest.z});
        }
    }
    return extent;
}

Bounds meshBounds(const Mesh& mesh, const glm::dmat4& objectToWorld) {
    Bounds box;
    for (const glm::uvec3& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            const glm::dvec3 position(mesh.positions[triangle[corner]]);
            box.add(glm::dvec3(objectToWorld * glm::dvec4(position, 1)));
        }
    }
    return box;
}

namespace {

// Of meshes with so many instances that sorting their vertices pays; empty for the others.
std::vector<std::optional<MeshExtent>> extentsOfRepeated(const Scene& scene) {
    constexpr std::size_t kMany = 8;
    std::vector<std::size_t> counts(scene.meshes.size(), 0);
    for (const std::vector<Object>* objects : {&scene.objects, &scene.csgLeaves}) {
        for (const Object& object : *objects) {
            if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
                ++counts.at(instance->mesh);
            }
        }
    }
    std::vector<std::optional<MeshExtent>> extents(scene.meshes.size());
    for (std::size_t mesh = 0; mesh < extents.size(); ++mesh) {
        if (counts[mesh] > kMany) {
            extents[mesh].emplace(scene.meshes[mesh]);
        }
    }
    return extents;
}

} // namespace

void findMeshBounds(Scene& scene) {
    const std::vector<std::optional<MeshExtent>> extents = extentsOfRepeated(scene);
    for (std::vector<Object>* objects : {&scene.objects, &scene.csgLeaves}) {
        parallelFor(objects->size(), 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (auto* instance = std::get_if<MeshInstance>(&(*objects)[i].shape)) {
                    const std::optional<MeshExtent>& extent = extents.at(instance->mesh);
                    instance->bounds = extent ? extent->under(instance->objectToWorld)
                                              : meshBounds(scene.meshes[instance->mesh], instance->objectToWorld);
                }
            }
        });
    }
}

double worldArea(const Mesh& mesh, const glm::dmat4& objectToWorld) {
    const glm::dmat3 linear(objectToWorld);
    double area = 0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::dvec3 corner(mesh.positions[triangle.x]);
        const glm::dvec3 edge0 = linear * (glm::dvec3(mesh.positions[triangle.y]) - corner);
        const glm::dvec3 edge1 = linear * (glm::dvec3(mesh.positions[triangle.z]) - corner);
        area += glm::length(glm::cross(edge0, edge1)) / 2;
    }
    return area;
}

Bounds worldBounds(const Sphere& sphere) {
    return {sphere.center - sphere.radius, sphere.center + sphere.radius};
}

Bounds worldBounds(const Quad& quad) {
    Bounds box;
    box.add(quad.corner);
    box.add(quad.corner + quad.edge0);
    box.add(quad.corner + quad.edge1);
    box.add(quad.corner + quad.edge0 + quad.edge1);
    return box;
}

Bounds worldBounds(const Disk& disk) {
    const glm::dvec3 reach = glm::sqrt(disk.axis0 * disk.axis0 + disk.axis1 * disk.axis1);
    return {disk.center - reach, disk.center + reach};
}

Bounds worldBounds(const Torus& torus) {
    // A ball swept along a circle: its extent along a world axis is that of the circle's image plus the ball's image.
    const glm::dmat3 rows = glm::transpose(glm::dmat3(torus.objectToWorld));
    Bounds box{glm::dvec3(torus.objectToWorld[3]), glm::dvec3(torus.objectToWorld[3])};
    for (int axis = 0; axis < 3; ++axis) {
        const double reach =
            torus.major * std::hypot(rows[axis].x, rows[axis].z) + torus.minor * glm::length(rows[axis]);
        box.low[axis] -= reach;
        box.high[axis] += reach;
    }
    return box;
}

Bounds worldBounds(const Scene& scene, const Object& object) {
    return std::visit([&](const auto& shape) { return shapeBounds(scene, shape); }, object.shape);
}

Bounds sceneBounds(const Scene& scene) {
    Bounds box;
    for (const Object& object : scene.objects) {
        const Bounds one = worldBounds(scene, object);
        if (isFinite(one) && !isEmpty(one)) {
            box.add(one.low);
            box.add(one.high);
        }
    }
    if (!(box.low.x <= box.high.x)) {
        box.add(scene.camera.position);
        box.add(scene.camera.lookAt);
    }
    return box;
}

LightSphere lightSphere(const Scene& scene) {
    Bounds box = sceneBounds(scene);
    const bool allEnd = std::all_of(scene.objects.begin(), scene.objects.end(),
                                    [&](const Object& object) { return isFinite(worldBounds(scene, object)); });
    if (!allEnd) {
        box.add(scene.camera.position);
        box.add(scene.camera.lookAt);
    }
    // A little wider than the box's corners, so that discs also cover what touches the sphere
    const double radius = 0.501 * glm::length(box.high - box.low);
    return {.center = 0.5 * (box.low + box.high), .radius = radius, .distance = allEnd ? radius : 16 * radius};
}

double sceneRadius(const Scene& scene) {
    const Bounds box = sceneBounds(scene);
    return glm::length(box.high - box.low) / 2;
}

double surfaceError(const Scene& scene) {
    const Bounds box = sceneBounds(scene);
    const glm::dvec3 farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
    return 0x1p-20 * (std::max({farthest.x, farthest.y, farthest.z}) + sceneRadius(scene));
}

double pixelFootprint(const Camera& camera) {
    return 2 * std::tan(glm::radians(camera.fov) / 2) / camera.resolution.y; // pixels are square
}

double globalSearchRadius(const Scene& scene) {
    return scene.render.radius > 0 ? scene.render.radius : sceneRadius(scene) / 8;
}

double causticSearchRadius(const Scene& scene) {
    const double radius = scene.render.photonMap.causticRadius;
    return radius > 0 ? radius : sceneRadius(scene) / 25;
}

} // namespace hyalite
