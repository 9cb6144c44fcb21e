// The scene file's materials.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// One entry of `materials:`; the scene has its textures. Throws Error(BadInput).
[[nodiscard]] Material readMaterial(const Value& value, const Scene& scene);

} // namespace hyalite
