// What is done for Mesa's software driver alone, to have the whole CPU. Wrong guesses cost time, never a bit of a
// picture.
#pragma once

#include <cstdint>
#include <filesystem>

namespace hyalite::gpu {

// Sets the variables that lavapipe reads when it is loaded; to be called before that, while there is one thread.
// Vectors of 512 bits where the CPU has AVX-512 (Mesa itself goes no farther than 256) unless LP_NATIVE_VECTOR_WIDTH
// names a width; and for each width a folder of its own for what Mesa compiled, in `cacheFolder` unless
// MESA_SHADER_CACHE_DIR names another: empty means no cache. Mesa 25.0.7 names compiled shaders without the width, and
// code of two widths in one cache crashes.
void prepareLavapipe(const std::filesystem::path& cacheFolder);

// Threads among which lavapipe divides the groups of a dispatch.
[[nodiscard]] std::uint32_t lavapipeThreads();

} // namespace hyalite::gpu
