// Light samples and their visibility.
#pragma once

#include "parity/sides.h"
#include "reference/lights/lights.h"

#include "shaders/shared/limits.h"

#include <cstdint>
#include <optional>

namespace hyalite::parity {

// The light that a kernel samples; none: picked at random.
[[nodiscard]] inline std::optional<std::uint32_t> lightOf(std::uint32_t number) {
    return number == shared::kNone ? std::nullopt : std::optional(number);
}

// True if the light sample is unoccluded. `leaves`: the object that the shadow ray leaves, see shared::Ray.
template <class Sample>
[[nodiscard]] bool isUnoccluded(const Sides& sides, const Sample& sample, std::uint32_t leaves) {
    const glm::dvec3 way = sample.to - sample.from;
    const double distance = glm::length(way);
    return !sides.trace({.origin = sample.from, .direction = way / distance, .tMax = distance}, leaves);
}

// The light that arrives along the sample's ray; `leaves` as above.
[[nodiscard]] inline glm::dvec3 lightAlong(const Sides& sides, const reference::LightSample& sample,
                                           std::uint32_t leaves) {
    if (sample.passes) {
        return reference::arriving(sides.world(), sample);
    }
    return isUnoccluded(sides, sample, leaves) ? sample.contribution : glm::dvec3(0);
}

} // namespace hyalite::parity
