// Triangle meshes and their instances: a mesh has one tree in its object space, and rays are transformed into it.
#pragma once

#include "reference/shapes/affine.h"
#include "reference/shapes/bvh.h"
#include "reference/shapes/ray.h"
#include "reference/shapes/triangle.h"
#include "scene/model/scene.h"

#include <memory>
#include <optional>

namespace hyalite::reference {

struct MeshTree {
    explicit MeshTree(Mesh source);

    [[nodiscard]] Triangle triangle(std::size_t index) const;

    Mesh mesh;
    Bvh bvh; // over its triangles
};

struct Instance {
    std::shared_ptr<const MeshTree> tree; // shared by all instances of a mesh
    Affine map;
};

// The nearest hit (of equally near hits, that of the first triangle), or any hit.
enum class Wanted { Nearest, Any };
[[nodiscard]] std::optional<ShapeHit> intersectInstance(const Ray& ray, const Instance& instance, Wanted wanted);

// A closed mesh as a solid: a point is inside if the winding number, the sum of the crossings on one side, is not 0.
[[nodiscard]] Crossings crossings(const Instance& instance, const Ray& line);
[[nodiscard]] bool isInside(const Instance& instance, const glm::dvec3& point);

[[nodiscard]] SurfacePoint surfaceAt(const Instance& instance, const Ray& ray, const ShapeHit& hit);

} // namespace hyalite::reference
