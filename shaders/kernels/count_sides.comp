#version 460
#extension GL_GOOGLE_include_directive : require
// Counts the photons in every chunk of a node's three lists that go to its left child.
// reads: lists, splits
// writes: photons per chunk that go to the left child
// threads: chunks
// computes: first half of a stable partition
#include "shared/kernel_arguments.h"
#include "photons/kdtree.glsl"
#include "photons/kdtree_chunk.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { CountSidesArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    NodeChunk chunk = nodeChunk(i, args.level, args.chunks, args.stored, args.nodes, args.splits);
    uint middle = chunk.middle.key[chunk.axis];
    uint left = 0u;
    for (uint at = chunk.begin; at < chunk.end; ++at) {
        uint key = args.lists.at[at].key[chunk.axis];
        left += key < middle || (key == middle && args.lists.at[at].photon < chunk.middle.photon) ? 1u : 0u;
    }
    args.counts.at[i] = left;
}
