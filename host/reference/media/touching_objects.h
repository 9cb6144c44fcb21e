// Objects whose surfaces coincide somewhere, with a dielectric among them: there rounding would decide which surface is
// hit.
#pragma once

#include "scene/model/scene.h"

#include <cstdint>
#include <vector>

namespace hyalite::reference {

struct World;

// For each object those that it touches, and itself among them, the larger ones first; nothing for objects that touch
// none. Empty if no objects touch. Found by rays from random points where the boxes of two objects meet: surfaces that
// coincide in less than about a hundredth of that region may be missed.
struct Neighbor {
    std::uint32_t object = 0;
    double extent = 0; // largest coordinate of the smaller one [m]
};
using Neighbors = std::vector<std::vector<Neighbor>>;
[[nodiscard]] Neighbors touchingObjects(const Scene& scene, const World& world);

// The same; prepares the scene only if some boxes meet.
[[nodiscard]] Neighbors touchingObjects(const Scene& scene);

} // namespace hyalite::reference
