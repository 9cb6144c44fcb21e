// Affine maps that shapes are placed by.
#pragma once

#include <glm/glm.hpp>

namespace hyalite {

// Whether the map has an inverse that floats can hold: no direction is shrunk or stretched beyond the range of
// lengths, and no two axes fall together.
[[nodiscard]] bool isInvertible(const glm::dmat4& matrix);

} // namespace hyalite
