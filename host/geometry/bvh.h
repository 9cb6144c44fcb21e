// The 4-wide bounding volume hierarchy of the device: built with the surface-area heuristic on all cores, then packed
// into quantised nodes whose layout shaders/shared/scene_records.h describes.
#pragma once

#include "geometry/aabb.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hyalite {

struct Bvh {
    std::vector<glm::uvec4> texels;   // kTexelsPerRecord a node, the root first
    std::vector<std::uint32_t> order; // element numbers in the order of the leaves
    std::uint32_t stackEntries = 0;   // most that a traversal needs: 1 for the root, then children as they are pushed
};

// Builds a hierarchy over the boxes' elements, at most `leafSize` (1..kLeafCountMax) to a leaf. The same tree for any
// number of threads. No element: a root without children. The result needs at most kTraversalStack entries: a tree
// that the heuristic makes too deep is split at medians instead.
[[nodiscard]] Bvh buildBvh(std::span<const Aabb> boxes, std::uint32_t leafSize);

// The words of the node's four children, see scene_records.h; kNone where there is none.
[[nodiscard]] glm::uvec4 childWords(std::span<const glm::uvec4> node);

// Moves the tree to stand behind others: its records and elements begin at the given ones.
void relocate(Bvh& bvh, std::uint32_t firstNode, std::uint32_t firstElement);

// A binary tree on the way to the packed one, down to single elements. Node 0 is the root; a node of n elements owns
// the 2n - 1 slots from its own on: its left child is the next slot, its right child follows the left subtree's slots.
struct BinaryNode {
    Aabb box;
    std::uint32_t first = 0; // range of `order`
    std::uint32_t count = 0;
    std::uint32_t right = 0; // slot of the right child; 0: one element
};

struct BinaryBvh {
    std::vector<BinaryNode> nodes;
    std::vector<std::uint32_t> order;
};

enum class SplitMethod { SurfaceArea, Median };

[[nodiscard]] BinaryBvh buildBinaryBvh(std::span<const Aabb> boxes, SplitMethod method);
[[nodiscard]] Bvh packBvh(const BinaryBvh& binary, std::uint32_t leafSize);

} // namespace hyalite
