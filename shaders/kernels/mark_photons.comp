#version 460
#extension GL_GOOGLE_include_directive : require
// Marks the slots that hold a photon; the others are empty.
// reads: photons
// writes: 1 per stored photon
// threads: photon slots
// computes: flags for a prefix sum
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { MarkPhotonsArguments args; };

void main() {
    uint i = threadIndex();
    if (i < args.count) {
        args.marks.at[i] = args.photons.at[i].surface == kNone ? 0u : 1u;
    }
}
