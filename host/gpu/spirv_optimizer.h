// Less for the driver to do: lavapipe takes every kernel through its compiler at each start, before it looks into its
// cache.
#pragma once

#include "gpu/spirv.h"

#include <map>

namespace hyalite::gpu {

// The same kernel with its functions inlined and its local variables turned into values; what it computes keeps every
// bit, for nothing is folded or reordered. Names of specialization constants stay.
[[nodiscard]] SpirV inlineFunctions(SpirV spirv);

// The same kernel with `constants`, by constant id, in place of its specialization constants, which all are gone then,
// and without the code that these values never reach. The rest computes the same bits.
[[nodiscard]] SpirV specialize(SpirV spirv, const std::map<std::uint32_t, std::uint32_t>& constants);

} // namespace hyalite::gpu
