// Direct light where a camera path leaves by a rough lobe: rays sampled from the lobe also find the lights, so the two
// strategies are combined with the power heuristic [Veach95].
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
    glm::dvec3 wo;           // unit, towards the origin of the path's last segment
    glm::dvec3 beta;         // path throughput, probability of the lobe divided out
    std::uint32_t depth = 0; // segments from the camera to here
    std::uint32_t samplerSeed = 0;
    Media media;  // on the side the path came from
    Media beyond; // on the other
};

// Weight of a sample of density `pdf` when the other strategy would sample it with density `other`; pdf > 0.
[[nodiscard]] double powerHeuristic(double pdf, double other);

// Like sampleLight, weighted.
[[nodiscard]] std::optional<LightSample> sampleRoughLight(const World& world, const RoughPoint& x, std::uint32_t pass,
                                                          std::optional<std::uint32_t> light, double shift = 0);

// Contribution of one such sample, of a light picked by the pmf; 0 if occluded.
[[nodiscard]] glm::dvec3 directRoughLight(const World& world, const RoughPoint& x, std::uint32_t pass);

} // namespace hyalite::reference
