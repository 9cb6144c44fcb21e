// Where the program finds its shaders and twins, and keeps what it compiled of them.
#pragma once

#include "reference/bsdf/custom_twins.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hyalite::cli {

// The folder with kernels/, lib/ and shared/: `given` if not empty, else the installed one beside the program, else
// the source tree's. Throws Error(WrongUsage) when the folder is not one of shaders.
[[nodiscard]] std::filesystem::path findShaders(const std::string& given);

// $XDG_CACHE_HOME/hyalite or ~/.cache/hyalite; empty (no cache) when the user has neither.
[[nodiscard]] std::filesystem::path cacheFolder();

// Where twins of scenes' own GLSL are looked for: the files `given`, and those that were built with the program, which
// may be gone.
[[nodiscard]] reference::TwinSources twinSources(const std::vector<std::string>& given);

// Where the kernels are that were compiled when the program was built; it may be gone.
[[nodiscard]] std::filesystem::path shippedKernels();

} // namespace hyalite::cli
