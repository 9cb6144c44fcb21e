// The folders of the program's shaders and twins, and of its cache of compiled shaders.
#pragma once

#include "reference/bsdf/custom_twins.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hyalite::cli {

// The folder with kernels/, lib/ and shared/: `given` if not empty, else the installed one beside the program, else
// the source tree's. Throws Error(WrongUsage) if the folder is not a folder of shaders.
[[nodiscard]] std::filesystem::path findShaders(const std::string& given);

// $XDG_CACHE_HOME/hyalite or ~/.cache/hyalite; empty (no cache) if neither variable is set.
[[nodiscard]] std::filesystem::path cacheFolder();

// Where to look for twins of custom GLSL: the given files and the folder of those built with the program, which may be
// missing.
[[nodiscard]] reference::TwinSources twinSources(const std::vector<std::string>& given);

// The folder of the kernels that were compiled with the program; it may be missing.
[[nodiscard]] std::filesystem::path shippedKernels();

} // namespace hyalite::cli
