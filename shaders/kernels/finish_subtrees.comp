#version 460
#extension GL_GOOGLE_include_directive : require
// Builds the kd-tree below one level, one thread per subtree: the subtrees are so small that splitting their lists
// among threads would cost more than it saves.
// reads: lists
// writes: splits of all nodes of the subtrees
// threads: subtrees
// computes: the splits of split_nodes and part_sides, a subtree per thread
#include "shared/kernel_arguments.h"
#include "photons/kdtree.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { FinishSubtreesArguments args; };

void partList(KdRange range, uint list, KdSplit split, KeyedPhotonArray lists, KeyedPhotonArray parted) {
    uint middle = split.middle.key[split.axis];
    uint left = list * args.stored + range.first;
    uint right = left + kdLeftCount(range.count) + 1u;
    uint end = left + range.count;
    for (uint at = left; at < end; ++at) {
        KeyedPhoton photon = lists.at[at];
        if (photon.photon != split.middle.photon) {
            bool goesLeft = isLeft(photon.key[split.axis], photon.photon, middle, split.middle.photon);
            parted.at[goesLeft ? left : right] = photon;
            left += goesLeft ? 1u : 0u;
            right += goesLeft ? 0u : 1u;
        }
    }
}

void main() {
    uint number = threadIndex();
    if (number >= args.count) {
        return;
    }
    KdRange whole = kdSubtree(KdRange(0u, args.stored), args.level, number);
    uint heap = args.count - 1u + number;
    for (uint level = 0u; (1u << level) <= whole.count; ++level) {
        KeyedPhotonArray lists = (level & 1u) == 0u ? args.lists : args.others;
        KeyedPhotonArray parted = (level & 1u) == 0u ? args.others : args.lists;
        for (uint child = 0u; child < (1u << level); ++child) {
            KdRange range = kdSubtree(whole, level, child);
            if (range.count == 0u) {
                break;
            }
            KdSplit split = splitNode(range, lists, args.stored);
            args.nodes.at[((heap + 1u) << level) - 1u + child] = nodeWord(split);
            for (uint list = 0u; list < 3u && range.count > 1u; ++list) {
                partList(range, list, split, lists, parted);
            }
        }
    }
}
