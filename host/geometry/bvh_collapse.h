// Chooses which nodes of a binary hierarchy become nodes, and which leaves, of the 4-wide one.
#pragma once

#include "geometry/bvh.h"

#include <array>

namespace hyalite {

// The choice of least expected cost for a ray: the sum over its nodes, and over the elements of its leaves, of the area
// of the box, a node costing as much as an element [Ylitie17].
class BvhCollapse {
public:
    // A reference is kept. Leaves have up to `leafSize` elements; those of the binary hierarchy have one.
    BvhCollapse(const BinaryBvh& binary, std::uint32_t leafSize);

    [[nodiscard]] bool isLeaf(std::uint32_t slot) const { return (choices_[slot] & kLeaf) != 0; }

    // The up to four children of a node; a leaf, which only the root of few elements is here, is its own only child.
    [[nodiscard]] std::vector<std::uint32_t> children(std::uint32_t slot) const;

private:
    // costs[i]: cost of the subtree below a binary node when it becomes up to i + 1 nodes or leaves.
    using Costs = std::array<float, 3>;

    Costs choose(std::uint32_t slot);
    void collect(std::uint32_t slot, std::uint32_t roots, std::vector<std::uint32_t>& list) const;

    // How many of `roots` (2 to 4) nodes or leaves the left subtree gets; 0: one fewer costs no more.
    static constexpr std::uint32_t kLeaf = 1;
    [[nodiscard]] std::uint32_t inLeft(std::uint32_t slot, std::uint32_t roots) const {
        return choices_[slot] >> (2 * roots - 3) & 3U;
    }
    void setInLeft(std::uint32_t slot, std::uint32_t roots, std::uint32_t left) {
        choices_[slot] = static_cast<std::uint8_t>(choices_[slot] | left << (2 * roots - 3));
    }

    const BinaryBvh& binary_;
    std::uint32_t leafSize_;
    std::vector<std::uint8_t> choices_; // by slot
};

} // namespace hyalite
