#version 460
#extension GL_GOOGLE_include_directive : require
// Copies the photons into grid order: the photons of a bucket are contiguous.
// reads: photons, their order
// writes: sorted photons (the photon table)
// threads: photons
// computes: gather by the sorted order
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { SortPhotonsArguments args; };

void main() {
    uint i = threadIndex();
    if (i < args.count) {
        args.sorted.at[i] = args.photons.at[args.order.at[i]];
    }
}
