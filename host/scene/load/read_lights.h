// Reads the scene file's lights that are not objects.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

#include <filesystem>

namespace hyalite {

// Reads one item of `lights:` and adds it to the scene; image paths are relative to `folder`. Throws Error(BadInput).
void readLight(const Value& value, const std::filesystem::path& folder, Scene& scene);

} // namespace hyalite
