// A shape as the kernels read it: the texels of its object (see shaders/shared/scene_records.h). Every type of
// hyalite::Shape has its record() in the file of its kind.
#pragma once

#include "scene/model/scene.h"

#include "shaders/shared/scene_records.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hyalite::kinds {

struct ObjectRecord {
    std::array<glm::vec4, shared::kTexelsPerObject> texels{}; // but the header, which the table writes
    shared::InstanceRecord instance{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    std::uint32_t type = 0; // and flags
    std::uint32_t root = 0;
};

// What shapes need to know of the tables around them.
struct ObjectTables {
    const Scene& scene;
    const std::vector<std::uint32_t>& meshRoots; // first node of each mesh
    std::vector<glm::uvec4>& geometry;           // programs of CSG go to its end
    std::uint32_t nextLeaf = 0;                  // object that the first leaf of the next CSG solid is
};

[[nodiscard]] ObjectRecord record(const Sphere& sphere, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Quad& quad, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Disk& disk, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Plane& plane, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Quadric& quadric, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Torus& torus, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const MeshInstance& instance, ObjectTables& tables);
[[nodiscard]] ObjectRecord record(const Csg& csg, ObjectTables& tables);

// How many leaves the solid has.
[[nodiscard]] std::uint32_t leafCount(const Csg& csg);

// What each leaf is to the solid, as bits of its type: reversed under an odd number of right operands of differences;
// required where nothing is left of the solid without it.
[[nodiscard]] std::vector<std::uint32_t> leafTypes(const Csg& csg);

// The bits of the integer, which a texel of floats holds.
[[nodiscard]] float bits(std::uint32_t value);

// Row i of an affine map.
[[nodiscard]] glm::vec4 row(const glm::dmat4& map, int i);

// The plane through a point with two axes, and coordinates in which the axes have length one: the rows of the inverse
// of (axis0, axis1, normal).
[[nodiscard]] ObjectRecord flatRecord(std::uint32_t type, const glm::dvec3& origin, const glm::dvec3& axis0,
                                      const glm::dvec3& axis1);

// The map from world space to the shape's own about `center` (object space), with the origin in world space where a
// float can hold it; returns that origin in object space.
glm::dvec3 setLocalSpace(ObjectRecord& r, const glm::dmat4& objectToWorld, const glm::dvec3& center);

} // namespace hyalite::kinds
