// The shape of a left-balanced kd-tree, which depends only on its count: every level but the last is full, the last is
// filled from the left, so node i of the heap order has the children 2i + 1 and 2i + 2 [Jensen01].
#ifndef HYALITE_SHARED_KD_TREE_H
#define HYALITE_SHARED_KD_TREE_H
#include "language.h"
SHARED_BEGIN

// Number of nodes in the left subtree of the root of a tree of `count` nodes.
SHARED_FUNCTION uint kdLeftCount(uint count) {
    uint levels = count; // becomes 2^h - 1, the nodes above the last level
    levels |= levels >> 1u;
    levels |= levels >> 2u;
    levels |= levels >> 4u;
    levels |= levels >> 8u;
    levels |= levels >> 16u;
    levels >>= 1u;
    if (levels == 0u) {
        return 0u;
    }
    uint last = count - levels;         // nodes of the last level
    uint halfLast = (levels + 1u) / 2u; // its places below the left child
    return (levels - 1u) / 2u + (last < halfLast ? last : halfLast);
}

// The range of a subtree's nodes in the order left subtree, node, right subtree.
struct KdRange {
    uint first;
    uint count;
};

// The range of node `number` of `level` below the root of `range`; empty if the tree has no such node.
SHARED_FUNCTION KdRange kdSubtree(KdRange range, uint level, uint number) {
    for (uint bit = level; bit > 0u && range.count > 0u; --bit) {
        uint left = kdLeftCount(range.count);
        if (((number >> (bit - 1u)) & 1u) == 0u) {
            range.count = left;
        } else {
            range.first += left + 1u;
            range.count -= left + 1u;
        }
    }
    return range;
}

SHARED_END
#endif
