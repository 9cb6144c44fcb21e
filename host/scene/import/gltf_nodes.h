// The nodes of a glTF scene: which mesh stands where.
#pragma once

#include "scene/import/gltf_document.h"

#include <glm/glm.hpp>
#include <vector>

namespace hyalite {

struct GltfPlacement {
    std::size_t node = 0; // in the file's "nodes"
    std::size_t mesh = 0; // in the file's "meshes"
    glm::dmat4 toFile{1}; // from the mesh's space to the file's, affine
};

// The meshes of the file's default scene, in the order in which its tree is walked from its roots; without scenes, of
// all nodes. Throws Error(BadInput): nodes that are no tree, malformed transforms, and skins, whose pose is not read.
[[nodiscard]] std::vector<GltfPlacement> placeGltfMeshes(GltfDocument& document);

} // namespace hyalite
