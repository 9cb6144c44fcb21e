// See light_tree.h. Nodes are split where the sum over both sides of intensity times solid angle of the directions
// times squared extent is least, the measure of [ContyEstevez18] with the box's diagonal for its surface.
#include "geometry/light_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>

namespace hyalite {

namespace {

using glm::dvec3;
using std::numbers::pi;

// Each side of a split gets at least one light in this many: bounds the depth of the tree.
constexpr std::size_t kLeastPart = 8;

struct Cone {
    dvec3 axis;
    double spread;
};

// The cone around both.
Cone around(const Cone& a, const Cone& b) {
    const double between = std::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0, 1.0));
    if (std::min(between + b.spread, pi) <= a.spread) {
        return a;
    }
    if (std::min(between + a.spread, pi) <= b.spread) {
        return b;
    }
    const double spread = (a.spread + between + b.spread) / 2;
    const dvec3 across = b.axis - glm::dot(a.axis, b.axis) * a.axis;
    if (spread >= pi || glm::length(across) < 1e-9) {
        return {a.axis, std::min(pi, spread >= pi ? pi : a.spread + between + b.spread)};
    }
    const double turn = spread - a.spread;
    return {glm::normalize(std::cos(turn) * a.axis + std::sin(turn) * glm::normalize(across)), spread};
}

LightExtent around(const LightExtent& a, const LightExtent& b) {
    const Cone cone = around(Cone{a.axis, a.spread}, Cone{b.axis, b.spread});
    LightExtent both{.box = a.box,
                     .axis = cone.axis,
                     .spread = cone.spread,
                     .fade = std::max(a.fade, b.fade),
                     .intensity = a.intensity + b.intensity};
    both.box.add(b.box.low);
    both.box.add(b.box.high);
    both.center = (both.box.low + both.box.high) / 2.0;
    both.radius = glm::length(both.box.high - both.box.low) / 2;
    return both;
}

// Solid angle of the directions in which the lights shine, weighted by the cosine outside the cone [sr].
double solidAngle(const LightExtent& e) {
    const double end = std::min(e.spread + e.fade, pi);
    return 2 * pi * (1 - std::cos(e.spread)) + pi / 2 *
                                                   (2 * end * std::sin(e.spread) - std::cos(e.spread - 2 * end) -
                                                    2 * e.spread * std::sin(e.spread) + std::cos(e.spread));
}

double cost(const LightExtent& e) {
    return e.intensity * solidAngle(e) * e.radius * e.radius;
}

class Builder {
public:
    Builder(const std::vector<LightExtent>& lights, LightTree& tree) : lights_(lights), tree_(tree) {}

    // Appends the subtree of these lights, whose order it changes; returns its root.
    std::uint32_t add(std::span<std::uint32_t> members, std::uint32_t parent) {
        const auto node = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.push_back({.extent = {}, .parent = parent});
        if (members.size() == 1) {
            tree_.nodes[node].extent = lights_[members.front()];
            tree_.nodes[node].light = members.front();
            tree_.leafOf[members.front()] = node;
            return node;
        }
        const std::size_t first = split(members);
        add(members.first(first), node);
        const std::uint32_t second = add(members.subspan(first), node);
        tree_.nodes[node].second = second;
        tree_.nodes[node].extent = around(tree_.nodes[node + 1].extent, tree_.nodes[second].extent);
        return node;
    }

private:
    void sortAlong(std::span<std::uint32_t> members, int axis) const {
        std::ranges::sort(members, {}, [&](std::uint32_t i) { return std::tuple(lights_[i].center[axis], i); });
    }

    // Costs of the groups of the first 1, 2, … members.
    [[nodiscard]] std::vector<double> costs(const std::vector<std::uint32_t>& members) const {
        std::vector<double> found;
        LightExtent sum = lights_[members.front()];
        for (std::size_t i = 0; i < members.size(); ++i) {
            sum = i == 0 ? sum : around(sum, lights_[members[i]]);
            found.push_back(cost(sum));
        }
        return found;
    }

    // Orders the members; returns the number of those on the first side.
    std::size_t split(std::span<std::uint32_t> members) const {
        const std::size_t count = members.size();
        const std::size_t least = std::max<std::size_t>(1, count / kLeastPart);
        std::tuple<double, std::size_t, int, std::size_t> best; // cost, distance from the middle, axis, first side
        bool found = false;
        for (int axis = 0; axis < 3; ++axis) {
            sortAlong(members, axis);
            const std::vector<double> low = costs({members.begin(), members.end()});
            const std::vector<double> high = costs({members.rbegin(), members.rend()});
            for (std::size_t first = least; first + least <= count; ++first) {
                const std::size_t off = std::max(2 * first, count) - std::min(2 * first, count);
                const std::tuple candidate(low[first - 1] + high[count - first - 1], off, axis, first);
                best = found ? std::min(best, candidate) : candidate;
                found = true;
            }
        }
        sortAlong(members, std::get<2>(best));
        return std::get<3>(best);
    }

    const std::vector<LightExtent>& lights_;
    LightTree& tree_;
};

} // namespace

LightTree buildLightTree(const std::vector<LightExtent>& lights) {
    LightTree tree;
    tree.leafOf.resize(lights.size());
    std::vector<std::uint32_t> members;
    double inTree = 0;
    double far = 0;
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
        (lights[i].isFar ? far : inTree) += lights[i].intensity;
        if (lights[i].isFar) {
            tree.leafOf[i] = tree.farCount++;
            tree.nodes.push_back({.extent = lights[i], .light = i});
        } else {
            members.push_back(i);
        }
    }
    if (!members.empty()) {
        Builder(lights, tree).add(members, shared::kNone);
    }
    const double unit = inTree > 0 ? inTree : far;
    for (LightTree::Node& node : tree.nodes) {
        node.extent.intensity /= unit;
    }
    return tree;
}

} // namespace hyalite
