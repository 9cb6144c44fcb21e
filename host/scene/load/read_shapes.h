// The scene file's shapes.
#pragma once

#include "kinds/shapes/shape_kind.h"

namespace hyalite {

// A shape with its own `transform` and `material` applied; not the object's emission. Where `parts` is given and then
// not empty, it holds all of the shape, and what is returned is of no meaning. Throws Error(BadInput).
[[nodiscard]] Object readShape(const Value& value, const kinds::Surroundings& around);

} // namespace hyalite
