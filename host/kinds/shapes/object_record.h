// A shape as the kernels read it: the texels of its object (see shaders/shared/scene_records.h). The record() of each
// type of hyalite::Shape is in the file of its kind.
#pragma once

#include "scene/model/scene.h"

#include "shaders/shared/scene_records.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hyalite::kinds {

struct ObjectRecord {
    std::array<glm::vec4, shared::kTexelsPerObject> texels{}; // without the header, which the table writes
    shared::InstanceRecord instance{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {}, 0};
    std::uint32_t type = 0; // with flags
    std::uint32_t root = 0;
};

// The tables that records of shapes refer to.
struct ObjectTables {
    const Scene& scene;
    const std::vector<std::uint32_t>& meshRoots; // first node of each mesh
    std::vector<glm::uvec4>& geometry;           // CSG programs are appended here
    std::uint32_t nextLeaf = 0;                  // object index of the first leaf of the next CSG solid
};

[[nodiscard]] ObjectRecord record(const Sphere& sphere, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Quad& quad, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Disk& disk, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Plane& plane, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Quadric& quadric, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Torus& torus, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const MeshInstance& instance, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Csg& csg, ObjectTables& tables);

// Number of leaves of the solid.
[[nodiscard]] std::uint32_t leafCount(const Csg& csg);

// The role of each leaf as bits of its type. Reversed: subtracted, i.e. under an odd number of right operands of
// differences. Required: a point outside the leaf is outside the solid.
[[nodiscard]] std::vector<std::uint32_t> leafTypes(const Csg& csg);

// The integer's bits as a float, to store in a texel of floats.
[[nodiscard]] float bits(std::uint32_t value);

// Row i of an affine map.
[[nodiscard]] glm::vec4 row(const glm::dmat4& map, int i);

// Record of the plane through a point spanned by two axes, with coordinates in which the axes have length one: the rows
// of the inverse of (axis0, axis1, normal).
[[nodiscard]] ObjectRecord flatRecord(std::uint32_t type, const glm::dvec3& origin, const glm::dvec3& axis0,
                                      const glm::dvec3& axis1);

// Writes the map from world space to the shape's local space about `center` (object space), with its origin in world
// space rounded to floats. Returns that rounded origin in object space.
glm::dvec3 setLocalSpace(ObjectRecord& r, const glm::dmat4& objectToWorld, const glm::dvec3& center);

} // namespace hyalite::kinds
