// Constructive solid geometry the classical way [Roth82]: the crossings of all leaves along the line, sorted, and what
// the tree of operations says about each stretch between them.
#pragma once

#include "reference/shapes/ray.h"
#include "reference/shapes/solid.h"
#include "scene/model/scene.h"

#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

namespace hyalite::reference {

// Which leaves a point is inside of.
using LeafSet = std::bitset<kMostCsgLeaves>;

struct CsgTree {
    struct Node {
        CsgStep step = CsgStep::Leaf;
        std::size_t left = 0;  // node; of a leaf: which
        std::size_t right = 0; // node
    };
    struct Leaf {
        Solid solid;
        bool reversed = false; // under an odd number of right operands of differences: its inside is what is taken away
    };

    // `leaves` are those of the program, in its order. Throws Error(BadInput) where they are none or too many for it.
    CsgTree(const Csg& csg, std::vector<Solid> solids, const SourceLocation& where);

    // Is a point inside that is inside these leaves?
    [[nodiscard]] bool contains(const LeafSet& inside) const { return contains(nodes.size() - 1, inside); }

    std::vector<Node> nodes; // the root comes last
    std::vector<Leaf> leaves;
    std::size_t firstLeaf; // in Scene::csgLeaves

private:
    [[nodiscard]] bool contains(std::size_t node, const LeafSet& inside) const;
    void markReversed(std::size_t node, bool reversed);
};

struct CsgHit {
    ShapeHit at;          // on the leaf
    std::size_t leaf = 0; // of the tree
    double spread = 0;    // [m] how far apart along the ray the crossings are that count as one place with this one
};

// The first place where the ray enters or leaves the solid.
//
// Crossings count as one place that lie within kPlace * max(t, largest |coordinate| of the ray's origin) behind the
// first of them: what coincides in the scene is told apart by rounding only, and must not show. The surface met is that
// of the first leaf crossed in the same sense as the solid and which decides: flipping it alone before or after the
// place flips the solid. Of this leaf's crossings in the place it is the last.
inline constexpr double kPlace = 0x1p-18;
[[nodiscard]] std::optional<CsgHit> intersectCsg(const Ray& ray, const CsgTree& tree);

[[nodiscard]] bool isInside(const CsgTree& tree, const glm::dvec3& point);

} // namespace hyalite::reference
