// What dielectrics absorb on the way through them.
#pragma once

#include "scene/model/scene.h"

namespace hyalite::reference {

// Share of the light that is left after a distance [m] in a material (nullptr: none): e^(-sigma t), the law of Beer and
// Lambert.
[[nodiscard]] glm::dvec3 transmittance(const Material* medium, double distance);

} // namespace hyalite::reference
