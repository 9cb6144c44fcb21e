// Affine maps that place shapes.
#pragma once

#include <glm/glm.hpp>

namespace hyalite {

// Whether the map has an inverse that floats can represent: it scales no direction beyond the range of lengths, and its
// image of the axes is not flat.
[[nodiscard]] bool isInvertible(const glm::dmat4& matrix);

} // namespace hyalite
