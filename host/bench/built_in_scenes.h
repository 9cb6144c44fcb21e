// Scenes built into the benchmark, so that figures from two machines are for the same rays.
#pragma once

#include "scene/model/scene.h"

#include <string>
#include <vector>

namespace hyalite::bench {

// Their names, in the order of measurement.
[[nodiscard]] const std::vector<std::string>& builtInScenes();

// Contract: `name` is one of them.
[[nodiscard]] Scene makeBuiltInScene(const std::string& name);

} // namespace hyalite::bench
