// Reads the scene file's materials.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// Reads one entry of `materials:`; the scene's textures must be loaded. Throws Error(BadInput).
[[nodiscard]] Material readMaterial(const Value& value, const Scene& scene);

} // namespace hyalite
