// Reduces the driver's work: lavapipe compiles every kernel at each start, before it looks into its cache.
#pragma once

#include "gpu/spirv.h"

#include <map>

namespace hyalite::gpu {

// The same kernel with its functions inlined and its local variables turned into values; every result keeps its bits,
// because nothing is folded or reordered. Names of specialization constants stay.
[[nodiscard]] SpirV inlineFunctions(SpirV spirv);

// The same kernel with `constants`, by constant id, in place of all its specialization constants, and without the code
// that these values make unreachable. The rest computes the same bits.
[[nodiscard]] SpirV specialize(SpirV spirv, const std::map<std::uint32_t, std::uint32_t>& constants);

} // namespace hyalite::gpu
