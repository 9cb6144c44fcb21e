// Where a mesh stands in the scene.
#pragma once

#include "kinds/shapes/shape_kind.h"

namespace hyalite::kinds {

// The mesh (index in Scene::meshes) at the shape's place, moved by `toObject` first. Throws Error(BadInput).
[[nodiscard]] MeshInstance placedMesh(const Reader& reader, const Surroundings& around, std::size_t mesh,
                                      const glm::dmat4& toObject = glm::dmat4(1));

} // namespace hyalite::kinds
