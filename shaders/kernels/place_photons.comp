#version 460
#extension GL_GOOGLE_include_directive : require
// Copies the photons to their nodes of the kd-tree, each with its split axis.
// reads: photons, splits
// writes: kd-tree (the photon table)
// threads: photons
// computes: heap order: node i has children 2i + 1, 2i + 2 [Wald22]
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { PlacePhotonsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    uint axisMask = 3u << kSplitAxisShift;
    uint node = args.nodes.at[i];
    uint slot = args.slots.at[node & ~axisMask];
    Photon photon = args.photons.at[slot];
    photon.direction = (photon.direction & ~axisMask) | (node & axisMask);
    args.sorted.at[i] = photon;
    args.order.at[i] = slot;
}
