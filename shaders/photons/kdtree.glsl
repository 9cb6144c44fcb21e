// What the kernels that build the kd-tree share: photons as three lists of numbers, each sorted along one axis and kept
// so within every node, so that the ends of a node's lists are its extent and the middle is where it splits [Wald22].
#ifndef HYALITE_KDTREE_GLSL
#define HYALITE_KDTREE_GLSL
#include "shared/kd_tree.h"
#include "shared/kernel_arguments.h"

// A number of the same order as the float; both zeros are one.
uint orderedBits(float x) {
    uint bits = x == 0.0 ? 0u : floatBitsToUint(x);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float fromOrderedBits(uint bits) {
    return uintBitsToFloat((bits & 0x80000000u) != 0u ? bits & 0x7fffffffu : ~bits);
}

// Where a node is split: along an axis, at the photon in the middle of the list along it.
struct KdSplit {
    uint axis;
    KeyedPhoton middle;
};

uint nodeWord(KdSplit split) {
    return split.middle.photon | (split.axis << kSplitAxisShift);
}

// The lists stand one after another, `stored` long each. The longest edge of the box about the node's photons decides,
// the first of equal ones.
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

// Of photons with equal coordinates the one with the lower number is the lesser.
bool isLeft(uint key, uint photon, uint middleKey, uint middlePhoton) {
    return key < middleKey || (key == middleKey && photon < middlePhoton);
}
#endif
