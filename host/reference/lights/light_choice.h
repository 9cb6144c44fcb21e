// Which light a receiver samples: picked by an estimate of what each light may bring there, without occlusion.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace hyalite::reference {

struct World;

struct LightPick {
    std::uint32_t light = 0;
    double pmf = 1; // probability of the pick at this receiver
};

// uv: uniform in [0, 1)^2. At least one light must emit.
[[nodiscard]] LightPick pickLightAt(const World& world, const glm::dvec3& receiver, glm::dvec2 uv);

// Probability that pickLightAt picks the light for this receiver.
[[nodiscard]] double pickProbability(const World& world, std::uint32_t light, const glm::dvec3& receiver);

} // namespace hyalite::reference
