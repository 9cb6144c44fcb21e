// See mesh_tables.h.
#include "render/upload/mesh_tables.h"

#include "geometry/bvh.h"

#include "shaders/shared/scene_records.h"

#include <algorithm>
#include <bit>

namespace hyalite::render {

namespace {

using glm::vec3;

// Leaves of one triangle are a tenth slower, of two or three within 2 %: measured on lavapipe.
constexpr std::uint32_t kTrianglesPerLeaf = 4;

std::uint32_t recordsOf(const std::vector<glm::uvec4>& geometry) {
    return static_cast<std::uint32_t>(geometry.size() / shared::kTexelsPerRecord);
}

glm::uvec4 texelOf(const vec3& corner) {
    return {std::bit_cast<std::uint32_t>(corner.x), std::bit_cast<std::uint32_t>(corner.y),
            std::bit_cast<std::uint32_t>(corner.z), 0};
}

// Appends the mesh's nodes, and writes its triangles to their place from `firstTriangle` on.
void addMesh(MeshTables& tables, std::size_t number, const Mesh& mesh, std::uint32_t firstTriangle) {
    std::vector<Aabb> boxes(mesh.triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            boxes[i].add(mesh.positions[mesh.triangles[i][corner]]);
        }
    }
    Bvh bvh = buildBvh(boxes, kTrianglesPerLeaf);
    if (tables.geometry.size() + bvh.texels.size() > std::size_t{shared::kLeafFirstMask} * shared::kTexelsPerRecord) {
        throw Error(ExitCode::BadInput, {mesh.file},
                    "more than 134 million triangles and nodes of hierarchies in the scene's meshes",
                    "use instances or coarser meshes");
    }
    const std::uint32_t root = recordsOf(tables.geometry);
    relocate(bvh, root, firstTriangle);
    tables.roots[number] = root;
    tables.stackEntries = std::max(tables.stackEntries, bvh.stackEntries);
    tables.geometry.insert(tables.geometry.end(), bvh.texels.begin(), bvh.texels.end());
    tables.fileOrder.insert(tables.fileOrder.end(), bvh.order.begin(), bvh.order.end());
    std::size_t texel = std::size_t{firstTriangle} * shared::kTexelsPerRecord;
    for (const std::uint32_t triangle : bvh.order) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.triangles[triangle][corner];
            tables.geometry[texel++] = texelOf(mesh.positions[vertex]);
            if (!mesh.normals.empty()) {
                tables.normals.push_back(mesh.normals[vertex]);
            }
        }
    }
}

} // namespace

MeshTables buildMeshTables(const std::vector<Mesh>& meshes) {
    MeshTables tables;
    tables.roots.resize(meshes.size());
    std::size_t triangles = 0;
    for (const Mesh& mesh : meshes) {
        triangles += mesh.triangles.size();
    }
    tables.geometry.reserve(triangles * (shared::kTexelsPerRecord + 1)); // about four triangles per node
    tables.geometry.resize(triangles * shared::kTexelsPerRecord);
    std::uint32_t placed = 0;
    for (const bool smooth : {true, false}) {
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            if (meshes[i].normals.empty() != smooth) {
                tables.order.push_back(static_cast<std::uint32_t>(i));
                addMesh(tables, i, meshes[i], placed);
                placed += static_cast<std::uint32_t>(meshes[i].triangles.size());
            }
        }
    }
    return tables;
}

} // namespace hyalite::render
