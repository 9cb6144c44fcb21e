// Scenes that the benchmark makes itself, so that figures of two machines are of the same rays.
#pragma once

#include "scene/model/scene.h"

#include <string>
#include <vector>

namespace hyalite::bench {

// Their names, in the order in which they are measured.
[[nodiscard]] const std::vector<std::string>& builtInScenes();

// Contract: `name` is one of them.
[[nodiscard]] Scene makeBuiltInScene(const std::string& name);

} // namespace hyalite::bench
