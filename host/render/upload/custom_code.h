// GLSL that a scene supplies, as the kernels include it.
#pragma once

#include "scene/model/scene.h"

#include <map>
#include <string>

namespace hyalite::render {

// Replacements of files of the shaders folder when kernels are compiled for the scene, by path; empty for a scene
// without its own code.
[[nodiscard]] std::map<std::string, std::string> customCode(const Scene& scene);

} // namespace hyalite::render
