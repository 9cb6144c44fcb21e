// The scene's meshes as the kernels read them: triangles in the order of their hierarchies' leaves.
#pragma once

#include "scene/model/scene.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace hyalite::render {

// All meshes, one after another; see shaders/shared/scene_records.h for the layouts.
struct MeshTables {
    std::vector<glm::uvec4> geometry;     // triangles, then nodes
    std::vector<glm::vec3> normals;       // of the meshes with normals, whose triangles come first
    std::vector<std::uint32_t> order;     // the meshes, in the order of their triangles
    std::vector<std::uint32_t> roots;     // by mesh: record of its root
    std::vector<std::uint32_t> fileOrder; // by triangle of the table: its number in the mesh file
    std::uint32_t stackEntries = 0;       // most stack entries that a ray needs in any mesh
};

// Throws Error(BadInput) if the meshes have more triangles and nodes than a leaf's bits can number.
[[nodiscard]] MeshTables buildMeshTables(const std::vector<Mesh>& meshes);

} // namespace hyalite::render
