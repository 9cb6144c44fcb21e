// See csg.h.
#include "reference/shapes/csg.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyalite::reference {

namespace {

struct LeafCrossing {
    ShapeHit at;
    std::size_t leaf = 0;
};

// The state at the start of the ray, and all later crossings, ascending in t.
struct Course {
    LeafSet start;
    std::vector<LeafCrossing> ahead;
};

Course courseOf(const Ray& ray, const CsgTree& tree) {
    Course course;
    for (std::size_t leaf = 0; leaf < tree.leaves.size(); ++leaf) {
        for (const Crossing& crossing : crossingsOf(tree.leaves[leaf].solid, ray)) {
            if (crossing.at.t <= 0) {
                course.start[leaf] = crossing.entering;
            } else if (std::isfinite(crossing.at.t)) {
                course.ahead.push_back({.at = crossing.at, .leaf = leaf});
            }
        }
    }
    std::ranges::stable_sort(course.ahead, {}, [](const LeafCrossing& crossing) { return crossing.at.t; });
    return course;
}

LeafSet flipped(const LeafSet& set, std::size_t leaf) {
    return LeafSet(set).flip(leaf);
}

// The leaf whose surface is hit between two states, one inside the solid and one outside.
std::size_t decidingLeaf(const CsgTree& tree, const LeafSet& before, const LeafSet& after) {
    const LeafSet changed = before ^ after;
    const bool wasInside = tree.contains(before);
    std::optional<std::size_t> firstChanged;
    for (std::size_t leaf = 0; leaf < tree.leaves.size(); ++leaf) {
        const bool entersSolid = after[leaf] != tree.leaves[leaf].reversed;
        if (!changed[leaf] || entersSolid == wasInside) { // crossed, and in the same sense as the solid
            continue;
        }
        if (tree.contains(flipped(before, leaf)) != wasInside || tree.contains(flipped(after, leaf)) == wasInside) {
            return leaf;
        }
        firstChanged = firstChanged.value_or(leaf);
    }
    return firstChanged.value();
}

} // namespace

CsgTree::CsgTree(const Csg& csg, std::vector<Solid> solids, const SourceLocation& where, const CsgExtent& size)
    : firstLeaf(csg.firstLeaf), extent(size) {
    if (solids.size() > kMostCsgLeaves) {
        throw Error(ExitCode::BadInput, where, "more than " + std::to_string(kMostCsgLeaves) + " leaves in a CSG tree",
                    "split it into several objects");
    }
    std::vector<std::size_t> stack;
    for (const CsgStep step : csg.program) {
        Node node{.step = step};
        if (step == CsgStep::Leaf) {
            node.left = leaves.size();
            leaves.push_back({.solid = std::move(solids.at(leaves.size()))});
        } else {
            if (stack.size() < 2) {
                throw Error(ExitCode::BadInput, where, "a CSG operation lacks an operand");
            }
            node.right = stack.back();
            stack.pop_back();
            node.left = stack.back();
            stack.pop_back();
        }
        stack.push_back(nodes.size());
        nodes.push_back(node);
    }
    if (stack.size() != 1) {
        throw Error(ExitCode::BadInput, where, "a CSG program must leave one solid");
    }
    markReversed(nodes.size() - 1, false);
}

void CsgTree::markReversed(std::size_t index, bool reversed) {
    const Node& node = nodes[index];
    if (node.step == CsgStep::Leaf) {
        leaves[node.left].reversed = reversed;
        return;
    }
    markReversed(node.left, reversed);
    markReversed(node.right, node.step == CsgStep::Difference ? !reversed : reversed);
}

bool CsgTree::contains(std::size_t index, const LeafSet& inside) const {
    const Node& node = nodes[index];
    if (node.step == CsgStep::Leaf) {
        return inside[node.left];
    }
    const bool left = contains(node.left, inside);
    const bool right = contains(node.right, inside);
    switch (node.step) {
    case CsgStep::Union:
        return left || right;
    case CsgStep::Intersection:
        return left && right;
    default:
        return left && !right;
    }
}

std::optional<CsgHit> intersectCsg(const Ray& given, const CsgTree& tree) {
    const double toSolid = glm::dot(tree.extent.center - given.origin, given.direction) - kBefore * tree.extent.radius;
    const double skipped = toSolid > kFar * tree.extent.radius ? toSolid : 0;
    const Ray ray{
        .origin = given.origin + skipped * given.direction, .direction = given.direction, .tMax = given.tMax - skipped};
    const Course course = courseOf(ray, tree);
    const glm::dvec3 magnitude = glm::abs(ray.origin);
    const double farthest = std::max({magnitude.x, magnitude.y, magnitude.z, tree.extent.reach});
    LeafSet state = course.start;
    for (std::size_t next = 0; next < course.ahead.size();) {
        const std::size_t first = next;
        const double tFirst = course.ahead[first].at.t;
        if (tFirst > ray.tMax) {
            break;
        }
        const LeafSet before = state;
        const double tLast = tFirst + kPlace * std::max(tFirst, farthest);
        for (; next < course.ahead.size() && course.ahead[next].at.t <= tLast; ++next) {
            state.flip(course.ahead[next].leaf);
        }
        if (tree.contains(state) == tree.contains(before)) {
            continue;
        }
        const std::size_t leaf = decidingLeaf(tree, before, state);
        std::size_t last = next - 1;
        while (course.ahead[last].leaf != leaf) {
            --last;
        }
        CsgHit hit{.at = course.ahead[last].at, .leaf = leaf, .spread = course.ahead[next - 1].at.t - tFirst};
        hit.at.t = skipped + tFirst;
        if (inRange(tFirst, ray)) {
            return hit;
        }
    }
    return std::nullopt;
}

bool isInside(const CsgTree& tree, const glm::dvec3& point) {
    LeafSet inside;
    for (std::size_t leaf = 0; leaf < tree.leaves.size(); ++leaf) {
        inside[leaf] = isInsideOf(tree.leaves[leaf].solid, point);
    }
    return tree.contains(inside);
}

} // namespace hyalite::reference
