// The scene file's `transform` lists: scale, rotate, translate and matrix, applied in the order of the list.
#pragma once

#include "scene/yaml/reader.h"

#include <glm/glm.hpp>

namespace hyalite {

// The object-to-world map, invertible and affine: applies the maps of the list in order, then `around`, the enclosing
// transform. Throws Error(BadInput).
[[nodiscard]] glm::dmat4 readTransform(const Value& value, const glm::dmat4& around = glm::dmat4(1));

} // namespace hyalite
