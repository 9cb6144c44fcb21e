// Learns what the lights do where the camera looks: see geometry/light_use.h.
#pragma once

#include "geometry/light_use.h"
#include "reference/world.h"

namespace hyalite::reference {

// Tries every light wherever the paths of a small picture meet a diffuse surface, up to kLearningDepth segments from
// the camera.
[[nodiscard]] std::vector<LightUse> tryLights(World world);

// Adds one try of a light at a visible point to its use.
void tryLight(const World& world, const VisiblePoint& x, std::uint32_t light, LightUse& use);

// Changes the probabilities of the world's lights, if it has enough lights for that. `shares`: of the lights, see
// photonShares.
void learnLights(World& world, const std::vector<double>& shares);

} // namespace hyalite::reference
