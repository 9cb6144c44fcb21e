// Reads the scene file's shapes.
#pragma once

#include "kinds/shapes/shape_kind.h"

namespace hyalite {

// Reads a shape and applies its own `transform` and `material`, but not the object's emission. If `around.parts` is set
// and not empty afterwards, it holds the whole shape and the returned object is meaningless. Throws Error(BadInput).
[[nodiscard]] Object readShape(const Value& value, const kinds::Surroundings& around);

} // namespace hyalite
