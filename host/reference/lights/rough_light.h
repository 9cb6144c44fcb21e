// Direct light where a camera path leaves by a rough lobe: rays that leave by the lobe find the lights too, and the two
// ways are weighed against one another by the power heuristic [Veach95].
#pragma once

#include "reference/bsdf/bsdf.h"
#include "reference/lights/lights.h"
#include "reference/world.h"

#include <cstdint>
#include <optional>

namespace hyalite::reference {

struct RoughPoint {
    Surface surface;
    Lobe lobe;
    glm::dvec3 wo;           // unit, to where the path came from
    glm::dvec3 beta;         // path throughput, probability of the lobe divided out
    std::uint32_t depth = 0; // segments from the camera to here
    std::uint32_t samplerSeed = 0;
};

// Weight of what was found with density `pdf` where the other way finds it with density `other`; pdf > 0.
[[nodiscard]] double powerHeuristic(double pdf, double other);

// As sampleLight, weighted.
[[nodiscard]] std::optional<LightSample> sampleRoughLight(const World& world, const RoughPoint& x, std::uint32_t pass,
                                                          std::optional<std::uint32_t> light, double shift = 0);

// The light of one such sample, of a light picked, if nothing stands between.
[[nodiscard]] glm::dvec3 directRoughLight(const World& world, const RoughPoint& x, std::uint32_t pass);

} // namespace hyalite::reference
