// The scene's textures as the kernels read them; see shaders/shared/scene_records.h for the layouts.
#pragma once

#include "render/upload/mesh_tables.h"
#include "scene/model/scene.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace hyalite::render {

// Does any material have a texture? If none has, kernels do not read either table.
[[nodiscard]] bool hasTextures(const Scene& scene);

// The texture table: all textures, then the texels of the images.
[[nodiscard]] std::vector<glm::vec4> textureTexels(const std::vector<Texture>& textures, const glm::dvec3& origin);

// The table of texture coordinates, triangle by triangle in the order of MeshTables; 0 in meshes that have none.
[[nodiscard]] std::vector<glm::vec4> coordinateTexels(const std::vector<Mesh>& meshes, const MeshTables& tables);

} // namespace hyalite::render
