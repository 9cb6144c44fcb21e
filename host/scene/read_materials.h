// The scene file's materials.
#pragma once

#include "scene/reader.h"
#include "scene/scene.h"

namespace hyalite {

// One entry of `materials:`. Throws Error(BadInput).
[[nodiscard]] Material readMaterial(const Value& value);

} // namespace hyalite
