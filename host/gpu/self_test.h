// A dispatch with a known answer: does the driver compute what the kernels need?
#pragma once

#include "gpu/context.h"
#include "gpu/kernel_compiler.h"

namespace hyalite::gpu {

// Runs kernels/self_test.comp: a loop longer than 65 535 rounds, texel fetches, reads of an unaligned struct. Throws
// Error(Device) with the wrong result and what to install: Mesa's lavapipe before version 23 silently ends long loops.
// Call it once before the first render on a Context.
void selfTest(const Context& context, const KernelCompiler& compiler);

} // namespace hyalite::gpu
