// What lights do where the camera looks, learned before the first pass: every light is tried from places that a few
// camera paths reach. Lights behind walls then get few picks and few photons.
#pragma once

#include "geometry/light_tree.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace hyalite {

struct LightUse {
    double brought = 0;      // light that the light's samples bring to pixels [W/(m^2 sr)], summed over the places
    std::uint32_t tried = 0; // places that the light would reach without occlusion
    std::uint32_t seen = 0;  // number of these where its sample is unoccluded
};

// More lights would take seconds to try; a single one is always picked.
inline constexpr std::size_t kMostLightsToLearn = 8192;

[[nodiscard]] inline bool learnsLights(std::size_t count) {
    return count > 1 && count <= kMostLightsToLearn;
}

// photonmap asks each light at every point, but of more lights than this only one, picked.
inline constexpr std::size_t kMostLightsAsked = 64;

// Part of the photons that are distributed by the light that the lights were found to bring.
inline constexpr double kLearnedPhotons = 0.5;

// Most intensity that the lights that were tried but never seen keep together, relative to those that were.
inline constexpr double kUnseenIntensity = 0.125;

// The pass whose random numbers the paths use; no picture has it.
inline constexpr std::uint32_t kLearningPass = 0xfffffffe;

// Longest path, in segments: light is gathered where it was reflected a few times too.
inline constexpr std::uint32_t kLearningDepth = 4;

// Pixels along each side of the small square picture whose paths are followed: some hundred thousand tries for all
// lights, but enough places.
[[nodiscard]] std::uint32_t learningSide(std::size_t lights);

// The photon shares of the scene's lights, in the order of lightExtents.
[[nodiscard]] std::vector<double> photonShares(const Scene& scene);

// Multiplies the intensity of every light by the part of it that is not occluded, as estimated from the tries:
// (seen + 1) / (tried + 2). The lights never seen keep a little, but together at most kUnseenIntensity of what those
// that were seen have; far lights and the others count separately.
void scaleIntensities(LightTree& tree, const std::vector<LightUse>& uses);

// The photons' pmf: kLearnedPhotons of it by share times the light brought, the rest as given. `pmf` if no light
// brought any.
[[nodiscard]] std::vector<double> learnedPmf(const std::vector<double>& pmf, const std::vector<double>& shares,
                                             const std::vector<LightUse>& uses);

} // namespace hyalite
