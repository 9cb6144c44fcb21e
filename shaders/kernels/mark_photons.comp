#version 460
#extension GL_GOOGLE_include_directive : require
// Tells the slots that hold a photon from the empty ones.
// reads: photons
// writes: 1 per stored photon
// threads: photon slots
// computes: –
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { MarkPhotonsArguments args; };

void main() {
    uint i = threadIndex();
    if (i < args.count) {
        args.marks.at[i] = args.photons.at[i].surface == kNone ? 0u : 1u;
    }
}
