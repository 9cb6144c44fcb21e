// A compiled kernel: SPIR-V as its words.
#pragma once

#include <cstdint>
#include <vector>

namespace hyalite::gpu {

using SpirV = std::vector<std::uint32_t>;

} // namespace hyalite::gpu
