// The scene's meshes as the kernels read them: triangles in the order of their hierarchies' leaves.
#pragma once

#include "scene/model/scene.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace hyalite::render {

// All meshes, one behind the other; see shaders/shared/scene_records.h for the layouts.
struct MeshTables {
    std::vector<glm::uvec4> geometry;     // triangles, then nodes
    std::vector<glm::vec3> normals;       // of the meshes that have some, whose triangles come first
    std::vector<std::uint32_t> order;     // the meshes, as their triangles stand
    std::vector<std::uint32_t> roots;     // by mesh: record of its root
    std::vector<std::uint32_t> fileOrder; // by triangle of the table: its number in the mesh file
    std::uint32_t stackEntries = 0;       // what a ray in one of the meshes needs at most
};

// Throws Error(BadInput) where the meshes together have more triangles and nodes than a leaf can name.
[[nodiscard]] MeshTables buildMeshTables(const std::vector<Mesh>& meshes);

} // namespace hyalite::render
