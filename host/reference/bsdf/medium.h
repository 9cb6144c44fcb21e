// Absorption inside dielectrics.
#pragma once

#include "scene/model/scene.h"

namespace hyalite::reference {

// Transmittance over a distance [m] in a material (nullptr: vacuum): e^(-sigma t), the Beer-Lambert law.
[[nodiscard]] glm::dvec3 transmittance(const Material* medium, double distance);

} // namespace hyalite::reference
