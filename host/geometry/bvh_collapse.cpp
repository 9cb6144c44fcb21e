#include "geometry/bvh_collapse.h"

#include <algorithm>
#include <limits>

namespace hyalite {

BvhCollapse::BvhCollapse(const BinaryBvh& binary, std::uint32_t leafSize)
    : binary_(binary), leafSize_(leafSize), choices_(binary.nodes.size()) {
    if (!binary.order.empty()) {
        choose(0);
    }
}

// Bottom up: the best choice for a subtree as one node or leaf, as two, as three does not depend on what is above it.
BvhCollapse::Costs BvhCollapse::choose(std::uint32_t slot) {
    const BinaryNode& node = binary_.nodes[slot];
    const float area = node.box.halfArea();
    const float leafCost =
        node.count <= leafSize_ ? area * static_cast<float>(node.count) : std::numeric_limits<float>::infinity();
    if (node.right == 0) {
        choices_[slot] = kLeaf;
        return {leafCost, leafCost, leafCost};
    }
    const Costs left = choose(slot + 1);
    const Costs right = choose(node.right);
    std::array<float, 5> asRoots{}; // cost by the number of roots, with some in either subtree
    for (std::uint32_t roots = 2; roots <= 4; ++roots) {
        std::uint32_t best = 1;
        for (std::uint32_t inLeft = 1; inLeft < roots; ++inLeft) {
            const float cost = left.at(inLeft - 1) + right.at(roots - inLeft - 1);
            if (inLeft == 1 || cost < asRoots.at(roots)) {
                asRoots.at(roots) = cost;
                best = inLeft;
            }
        }
        setInLeft(slot, roots, best);
    }
    const float nodeCost = area + asRoots[4];
    if (leafCost <= nodeCost) {
        choices_[slot] |= kLeaf;
    }
    Costs costs{std::min(leafCost, nodeCost), asRoots[2], asRoots[3]};
    for (std::uint32_t roots = 2; roots <= 3; ++roots) {
        if (costs.at(roots - 2) <= costs.at(roots - 1)) {
            costs.at(roots - 1) = costs.at(roots - 2);
            choices_[slot] = static_cast<std::uint8_t>(choices_[slot] & ~(3U << (2 * roots - 3)));
        }
    }
    return costs;
}

std::vector<std::uint32_t> BvhCollapse::children(std::uint32_t slot) const {
    if (binary_.order.empty()) {
        return {};
    }
    if (isLeaf(slot)) {
        return {slot};
    }
    std::vector<std::uint32_t> list;
    const std::uint32_t left = inLeft(slot, 4);
    collect(slot + 1, left, list);
    collect(binary_.nodes[slot].right, 4 - left, list);
    return list;
}

void BvhCollapse::collect(std::uint32_t slot, std::uint32_t roots, std::vector<std::uint32_t>& list) const {
    const bool isElement = binary_.nodes[slot].right == 0;
    while (roots > 1 && (isElement || inLeft(slot, roots) == 0)) {
        --roots;
    }
    if (roots == 1) {
        list.push_back(slot);
        return;
    }
    const std::uint32_t left = inLeft(slot, roots);
    collect(slot + 1, left, list);
    collect(binary_.nodes[slot].right, roots - left, list);
}

} // namespace hyalite
