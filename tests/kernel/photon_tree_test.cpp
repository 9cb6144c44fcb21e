// The kd-tree that the kernels build, against its definition.
#include "base/error.h"
#include "kernel/photon_sets.h"
#include "render/photons/photon_tree.h"

#include "shaders/shared/kd_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace hyalite::testing {

namespace {

std::uint32_t axisOf(const shared::Photon& photon) {
    return photon.direction >> shared::kSplitAxisShift;
}

// A node's photons as (coordinate, slot): what the left ones are below and the right ones above.
std::pair<float, std::uint32_t> keyOf(const shared::Photon& photon, std::uint32_t slot, std::uint32_t axis) {
    return {photon.position[static_cast<int>(axis)], slot};
}

struct Subtree {
    vec3 low{INFINITY};
    vec3 high{-INFINITY};
    std::uint32_t count = 0;
};

struct BuiltTree {
    std::vector<shared::Photon> nodes;
    std::vector<std::uint32_t> slots;

    // Is every photon under `node` on the right side of every node above it? A walk up from each.
    [[nodiscard]] bool isOrdered(std::uint32_t node) const {
        for (std::uint32_t child = node; child > 0;) {
            const std::uint32_t parent = (child - 1) / 2;
            const std::uint32_t axis = axisOf(nodes[parent]);
            const bool isLeft = child == 2 * parent + 1;
            if ((keyOf(nodes[node], slots[node], axis) < keyOf(nodes[parent], slots[parent], axis)) != isLeft) {
                return false;
            }
            child = parent;
        }
        return true;
    }

    // Checks the axis of every node: the longest edge of its subtree's box, the first of equal ones.
    [[nodiscard]] std::size_t wrongAxes() const {
        std::vector<Subtree> subtrees(nodes.size());
        std::size_t wrong = 0;
        for (auto node = static_cast<std::uint32_t>(nodes.size()); node-- > 0;) {
            Subtree& subtree = subtrees[node];
            subtree = {nodes[node].position, nodes[node].position, 1};
            for (const std::uint32_t child : {2 * node + 1, 2 * node + 2}) {
                if (child < nodes.size()) {
                    subtree.low = glm::min(subtree.low, subtrees[child].low);
                    subtree.high = glm::max(subtree.high, subtrees[child].high);
                    subtree.count += subtrees[child].count;
                }
            }
            const vec3 edge = subtree.high - subtree.low;
            const std::uint32_t axis = edge.x >= edge.y && edge.x >= edge.z ? 0 : (edge.y >= edge.z ? 1 : 2);
            wrong += axis == axisOf(nodes[node]) ? 0 : 1;
        }
        return wrong;
    }
};

BuiltTree buildTree(BothSides& both, render::PhotonTree& tree, const std::vector<shared::Photon>& photons) {
    const auto devicePhotons = both.upload(photons);
    const std::uint32_t base = 5;
    const auto table = both.room<shared::Photon>(photons.size() + base);
    tree.build(both.device, devicePhotons, static_cast<std::uint32_t>(photons.size()), table, base);
    both.device.commands.finish();
    const auto nodes = table.read(base, tree.photonCount());
    const auto slots = tree.order().read(0, tree.photonCount());
    return {{nodes.begin(), nodes.end()}, {slots.begin(), slots.end()}};
}

} // namespace

TEST_CASE("the left subtree of a left-balanced tree holds the nodes whose way from the root begins with a left turn") {
    for (std::uint32_t count = 1; count < 700; ++count) {
        std::uint32_t left = 0;
        for (std::uint32_t node = 1; node < count; ++node) {
            std::uint32_t top = node;
            while (top > 2) {
                top = (top - 1) / 2;
            }
            left += top == 1 ? 1 : 0;
        }
        REQUIRE(shared::kdLeftCount(count) == left);
    }
}

TEST_CASE("every photon stands once in the tree, on its side of every node above, split along the longest edge") {
    BothSides both(reference::test::cornellBox());
    render::PhotonTree tree(both.device);
    std::vector<PhotonSet> sets = hardPhotonSets(20000);
    for (const std::uint32_t count : {3U, 7U, 8U, 511U, 512U, 513U, 1025U, 4099U}) { // about the limits of levels
        sets.push_back(
            {"volume of " + std::to_string(count), {sets[4].positions.begin(), sets[4].positions.begin() + count}});
    }
    for (const PhotonSet& set : sets) {
        INFO(set.name);
        const auto photons = slotsOf(set);
        const BuiltTree built = buildTree(both, tree, photons);
        REQUIRE(built.nodes.size() == set.positions.size());
        std::vector<bool> seen(photons.size(), false);
        for (std::uint32_t node = 0; node < built.nodes.size(); ++node) {
            const std::uint32_t slot = built.slots[node];
            REQUIRE(!seen[slot]);
            seen[slot] = true;
            shared::Photon expected = photons[slot];
            REQUIRE(expected.surface != shared::kNone);
            expected.direction |= axisOf(built.nodes[node]) << shared::kSplitAxisShift;
            using Words = std::array<std::uint32_t, sizeof expected / sizeof(std::uint32_t)>;
            REQUIRE(std::bit_cast<Words>(expected) == std::bit_cast<Words>(built.nodes[node]));
            REQUIRE(built.isOrdered(node));
        }
        CHECK(built.wrongAxes() == 0);
    }
}

TEST_CASE("a tree is the same whatever stood in its memory before") {
    BothSides both(reference::test::cornellBox());
    render::PhotonTree used(both.device);
    render::PhotonTree fresh(both.device);
    const std::vector<PhotonSet> sets = hardPhotonSets(5000);
    for (const PhotonSet& set : sets) {
        INFO(set.name);
        const auto photons = slotsOf(set);
        CHECK(buildTree(both, used, photons).slots == buildTree(both, fresh, photons).slots);
        fresh = render::PhotonTree(both.device);
    }
}

TEST_CASE("photons that find no room in the table are refused") {
    BothSides both(reference::test::cornellBox());
    render::PhotonTree tree(both.device);
    const auto photons = both.upload(slotsOf(hardPhotonSets(100)[4]));
    const auto table = both.room<shared::Photon>(150);
    CHECK_THROWS_WITH(tree.build(both.device, photons, static_cast<std::uint32_t>(photons.count()), table, 51),
                      Catch::Matchers::ContainsSubstring("has no room for 100 photons from 51"));
}

} // namespace hyalite::testing
