// Shared by the kernels that build the kd-tree: photons as three lists of numbers, each sorted along one axis and kept
// sorted within every node. The ends of a node's lists are its extent, and the middle is where it splits [Wald22].
#ifndef HYALITE_KDTREE_GLSL
#define HYALITE_KDTREE_GLSL
#include "shared/kd_tree.h"
#include "shared/kernel_arguments.h"

// An integer with the same order as the float; both zeros map to one.
uint orderedBits(float x) {
    uint bits = x == 0.0 ? 0u : floatBitsToUint(x);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float fromOrderedBits(uint bits) {
    return uintBitsToFloat((bits & 0x80000000u) != 0u ? bits & 0x7fffffffu : ~bits);
}

// The split of a node: the axis, and the photon in the middle of the list along it.
struct KdSplit {
    uint axis;
    KeyedPhoton middle;
};

uint nodeWord(KdSplit split) {
    return split.middle.photon | (split.axis << kSplitAxisShift);
}

// The lists are stored one after another, `stored` elements each. The node splits along the longest edge of the box
// around its photons, the first of equal ones.
KdSplit splitNode(KdRange range, KeyedPhotonArray lists, uint stored) {
    uint longestAxis = 0u;
    float longest = -1.0;
    for (uint axis = 0u; axis < 3u; ++axis) {
        uint first = axis * stored + range.first;
        float low = fromOrderedBits(lists.at[first].key[axis]);
        float high = fromOrderedBits(lists.at[first + range.count - 1u].key[axis]);
        if (high - low > longest) {
            longest = high - low;
            longestAxis = axis;
        }
    }
    return KdSplit(longestAxis, lists.at[longestAxis * stored + range.first + kdLeftCount(range.count)]);
}

// Photons with equal coordinates are ordered by number.
bool isLeft(uint key, uint photon, uint middleKey, uint middlePhoton) {
    return key < middleKey || (key == middleKey && photon < middlePhoton);
}
#endif
