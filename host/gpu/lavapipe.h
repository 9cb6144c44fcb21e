// Settings for Mesa's software driver, so that it uses the whole CPU. Wrong guesses cost time, never a bit of a
// picture.
#pragma once

#include <cstdint>
#include <filesystem>

namespace hyalite::gpu {

// Sets the environment variables that lavapipe reads when it is loaded; call it before that, while there is one thread.
// Vectors of 512 bits if the CPU has AVX-512 (Mesa itself stops at 256) unless LP_NATIVE_VECTOR_WIDTH names a width. A
// separate folder per width for Mesa's compiled shaders, in `cacheFolder` unless MESA_SHADER_CACHE_DIR names another;
// empty means no cache. Mesa 25.0.7 names compiled shaders without the width, and code of two widths in one cache
// crashes.
void prepareLavapipe(const std::filesystem::path& cacheFolder);

// Number of threads among which lavapipe divides the groups of a dispatch.
[[nodiscard]] std::uint32_t lavapipeThreads();

} // namespace hyalite::gpu
