// A hierarchy over the lights, by which a light is picked for a receiver: bounds of position, directions and intensity
// for each group of lights [ContyEstevez18]. Lights whose strength does not fall off with distance stay beside it.
#pragma once

#include "geometry/light_extents.h"

#include "shaders/shared/limits.h"

#include <cstdint>
#include <vector>

namespace hyalite {

struct LightTree {
    struct Node {
        LightExtent extent;                   // of all its lights; the intensity is their sum
        std::uint32_t parent = shared::kNone; // kNone: the root, or a far light
        std::uint32_t second = 0;             // its second child; the first is the next node; 0: it is a light
        std::uint32_t light = shared::kNone;  // number of that light
    };
    std::vector<Node> nodes;           // the far lights in their order, then the tree, depth first
    std::uint32_t farCount = 0;        // number of far lights: also the root, unless all lights are far
    std::vector<std::uint32_t> leafOf; // the node of each light
};

// Intensities are scaled so that those of the lights in the tree (without any: those of the far lights) add up to 1;
// what a receiver compares does not change. Deterministic.
[[nodiscard]] LightTree buildLightTree(const std::vector<LightExtent>& lights);

} // namespace hyalite
