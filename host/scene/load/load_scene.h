// Loads a scene file (YAML, hence JSON too) as a Scene. docs/scene-format.md and the JSON Schema
// scenes/hyalite.schema.json describe the format.
#pragma once

#include "scene/model/scene.h"

#include <filesystem>

namespace hyalite {

// Reads a scene and the files it names (paths relative to the scene file).
// Throws Error(BadInput) with file:line:column at the first mistake; an unknown key is a mistake.
[[nodiscard]] Scene loadScene(const std::filesystem::path& file);

} // namespace hyalite
