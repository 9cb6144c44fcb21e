#version 460
#extension GL_GOOGLE_include_directive : require
// Partitions the three lists of every node of one level into left child, splitting photon (which leaves the lists here)
// and right child, each in its previous order.
// reads: lists, splits, prefix sums of the left counts
// writes: lists of the next level
// threads: chunks
// computes: stable partition [Brown15]
#include "shared/kernel_arguments.h"
#include "photons/kdtree.glsl"
#include "photons/kdtree_chunk.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { PartSidesArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    NodeChunk chunk = nodeChunk(i, args.level, args.chunks, args.stored, args.nodes, args.splits);
    uint middle = chunk.middle.key[chunk.axis];
    uint leftBefore = args.sums.at[i] - args.sums.at[i - chunk.number];
    uint left = chunk.first + leftBefore;
    uint right = chunk.first + kdLeftCount(chunk.nodeCount) + 1u + (chunk.begin - chunk.first) - leftBefore;
    if (chunk.begin > chunk.first && chunk.begin < chunk.end) {
        // The splitting photon goes to neither side; skip it if this list has it before the chunk
        KeyedPhoton next = args.lists.at[chunk.begin];
        right -= isLeft(chunk.middle.key[chunk.list], chunk.middle.photon, next.key[chunk.list], next.photon) ? 1u : 0u;
    }
    for (uint at = chunk.begin; at < chunk.end; ++at) {
        KeyedPhoton photon = args.lists.at[at];
        if (photon.photon != chunk.middle.photon) {
            bool goesLeft = isLeft(photon.key[chunk.axis], photon.photon, middle, chunk.middle.photon);
            args.parted.at[goesLeft ? left : right] = photon;
            left += goesLeft ? 1u : 0u;
            right += goesLeft ? 0u : 1u;
        }
    }
}
