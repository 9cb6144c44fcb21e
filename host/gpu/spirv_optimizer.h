// Less for the driver to do: lavapipe takes every kernel through its compiler at each start, before it looks into its
// cache.
#pragma once

#include "gpu/shader_compiler.h"

namespace hyalite::gpu {

// The same kernel with its functions inlined and its local variables turned into values; what it computes keeps every
// bit, for nothing is folded or reordered. Names of specialization constants stay.
[[nodiscard]] SpirV inlineFunctions(SpirV spirv);

} // namespace hyalite::gpu
