// Caustic photons go where something specular is: towards World::targets, as cones from a point of a light or as discs
// across parallel light [Jensen01].
#pragma once

#include "reference/lights/lights.h"

#include <cstdint>

namespace hyalite::reference {

// As emitPhoton, but of the rays towards the targets only; there is one target at least. The flux of a photon is what
// the light sends per unit of density along its ray; 0 where the light does not shine.
[[nodiscard]] Emission emitAimedPhoton(const World& world, std::uint32_t photon, const PhotonPass& pass,
                                       double shift = 0);

} // namespace hyalite::reference
