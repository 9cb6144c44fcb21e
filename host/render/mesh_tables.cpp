// See mesh_tables.h.
#include "render/mesh_tables.h"

#include "geometry/bvh.h"

#include "shaders/shared/scene_records.h"

namespace hyalite::render {

namespace {

using glm::vec3;
using glm::vec4;

// A triangle costs about one box test. An estimate, not yet measured.
constexpr std::uint32_t kTrianglesPerLeaf = 4;

void appendMesh(MeshTables& tables, std::size_t number, const Mesh& mesh) {
    std::vector<Aabb> boxes(mesh.triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            boxes[i].add(mesh.positions[mesh.triangles[i][corner]]);
        }
    }
    Bvh bvh = buildBvh(boxes, kTrianglesPerLeaf);
    const auto firstNode = static_cast<std::uint32_t>(tables.nodes.size() / shared::kTexelsPerNode);
    const auto firstTriangle = static_cast<std::uint32_t>(tables.triangles.size() / shared::kTexelsPerTriangle);
    if (firstTriangle + mesh.triangles.size() > shared::kLeafFirstMask) {
        throw Error(ExitCode::BadInput, {mesh.file}, "more than 134 million triangles in the scene's meshes",
                    "use instances or coarser meshes");
    }
    relocate(bvh, firstNode, firstTriangle);
    tables.roots[number] = firstNode;
    tables.nodes.insert(tables.nodes.end(), bvh.texels.begin(), bvh.texels.end());
    tables.fileOrder.insert(tables.fileOrder.end(), bvh.order.begin(), bvh.order.end());
    for (const std::uint32_t triangle : bvh.order) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.triangles[triangle][corner];
            tables.triangles.emplace_back(mesh.positions[vertex], 0.0F);
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
    for (const bool smooth : {true, false}) {
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            if (meshes[i].normals.empty() != smooth) {
                tables.order.push_back(static_cast<std::uint32_t>(i));
                appendMesh(tables, i, meshes[i]);
            }
        }
    }
    return tables;
}

} // namespace hyalite::render
