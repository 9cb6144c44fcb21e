#version 460
#extension GL_GOOGLE_include_directive : require
// Chooses the axis and the photon that split each node of one level of the kd-tree.
// reads: lists of photons along three axes
// writes: splitting photon and axis of each node of a level
// threads: nodes
// computes: split the longest edge at the middle photon [Jensen01]
#include "shared/kernel_arguments.h"
#include "photons/kdtree.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { SplitNodesArguments args; };

void main() {
    uint number = threadIndex();
    if (number >= args.count) {
        return;
    }
    KdRange range = kdSubtree(KdRange(0u, args.stored), args.level, number);
    KdSplit split = splitNode(range, args.lists, args.stored);
    args.nodes.at[args.count - 1u + number] = nodeWord(split);
    args.splits.at[number] = split.middle;
}
