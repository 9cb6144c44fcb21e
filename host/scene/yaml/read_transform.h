// The scene file's `transform` lists: scale, rotate, translate and matrix, applied in the order of the list.
#pragma once

#include "scene/yaml/reader.h"

#include <glm/glm.hpp>

namespace hyalite {

// Object to world, invertible and affine: the product of the list's maps, the first of them applied first, and then of
// what is around them. Throws Error(BadInput).
[[nodiscard]] glm::dmat4 readTransform(const Value& value, const glm::dmat4& around = glm::dmat4(1));

} // namespace hyalite
