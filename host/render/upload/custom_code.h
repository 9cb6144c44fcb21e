// GLSL that a scene brings along, as the kernels take it in.
#pragma once

#include "scene/model/scene.h"

#include <map>
#include <string>

namespace hyalite::render {

// What stands in place of files of the shaders folder when kernels are compiled for the scene, by path: nothing for a
// scene without code of its own.
[[nodiscard]] std::map<std::string, std::string> customCode(const Scene& scene);

} // namespace hyalite::render
