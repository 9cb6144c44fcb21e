// Classical constructive solid geometry [Roth82]: sorts the crossings of all leaves along the line, and evaluates the
// tree of operations on each interval between them.
#pragma once

#include "reference/shapes/ray.h"
#include "reference/shapes/solid.h"
#include "scene/model/bounds.h"
#include "scene/model/scene.h"

#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

namespace hyalite::reference {

// The leaves that contain a point.
using LeafSet = std::bitset<kMostCsgLeaves>;

struct CsgTree {
    struct Node {
        CsgStep step = CsgStep::Leaf;
        std::size_t left = 0;  // node; for a leaf: its index
        std::size_t right = 0; // node
    };
    struct Leaf {
        Solid solid;
        bool reversed = false; // under an odd number of right operands of differences: its inside is subtracted
    };

    // `solids` are the leaves of the program, in its order. Throws Error(BadInput) if there are none, or too many.
    CsgTree(const Csg& csg, std::vector<Solid> solids, const SourceLocation& where, const CsgExtent& extent = {});

    // True if a point inside exactly these leaves is inside the solid.
    [[nodiscard]] bool contains(const LeafSet& inside) const { return contains(nodes.size() - 1, inside); }

    std::vector<Node> nodes; // the root comes last
    std::vector<Leaf> leaves;
    std::size_t firstLeaf; // in Scene::csgLeaves
    CsgExtent extent;

private:
    [[nodiscard]] bool contains(std::size_t node, const LeafSet& inside) const;
    void markReversed(std::size_t node, bool reversed);
};

struct CsgHit {
    ShapeHit at;          // on the leaf
    std::size_t leaf = 0; // of the tree
    double spread = 0;    // [m] distance along the ray between the crossings that count as one place with this one
};

// The first place where the ray enters or leaves the solid. Crossings within kPlace * max(t, largest |coordinate| of
// the ray's origin, extent.reach), for a ray from afar with its origin moved to kBefore radii from the solid, behind
// the first one count as one place: only rounding separates surfaces that coincide in the scene, and that must not
// show. The surface hit is that of the first leaf that is crossed in the same sense as the solid and decides, meaning
// that flipping it alone before or after the place flips the solid. The hit is the last of this leaf's crossings in the
// place.
inline constexpr double kPlace = 0x1p-18;
inline constexpr double kFar = 16;   // rays that start farther than this before the moved origin are from afar [radii]
inline constexpr double kBefore = 2; // [radii]
[[nodiscard]] std::optional<CsgHit> intersectCsg(const Ray& ray, const CsgTree& tree);

[[nodiscard]] bool isInside(const CsgTree& tree, const glm::dvec3& point);

} // namespace hyalite::reference
