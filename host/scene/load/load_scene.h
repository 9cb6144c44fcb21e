// Scene file (YAML, hence JSON too) to Scene. The format is described in docs/scene-format.md and by the JSON Schema
// scenes/hyalite.schema.json.
#pragma once

#include "scene/model/scene.h"

#include <filesystem>

namespace hyalite {

// Reads a scene and the meshes it names (paths relative to the scene file).
// Throws Error(BadInput) with file:line:column at the first mistake; unknown keys are mistakes.
[[nodiscard]] Scene loadScene(const std::filesystem::path& file);

} // namespace hyalite
