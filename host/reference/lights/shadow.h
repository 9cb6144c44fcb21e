// Shadow rays that pass through glass: what of the light arrives straight on.
#pragma once

#include "reference/world.h"

namespace hyalite::reference {

// True if a dielectric of the scene may let shadow rays pass: thin glass, or a boundary that does not refract.
[[nodiscard]] bool hasStraightGlass(const std::vector<Material>& materials);

// Transmittance of the segment between two points, both moved off their surfaces: absorption on the way, times what
// thin glass transmits; 0 if anything else is in between. `media`: around the start.
[[nodiscard]] glm::dvec3 straightTransmittance(const World& world, const glm::dvec3& from, const glm::dvec3& to,
                                               Media media);

} // namespace hyalite::reference
