// Places a mesh in the scene.
#pragma once

#include "kinds/shapes/shape_kind.h"

namespace hyalite::kinds {

// The mesh (index in Scene::meshes) under `toObject`, then the shape's placement. Throws Error(BadInput).
[[nodiscard]] MeshInstance placedMesh(const Reader& reader, const Surroundings& around, std::size_t mesh,
                                      const glm::dmat4& toObject = glm::dmat4(1));

} // namespace hyalite::kinds
