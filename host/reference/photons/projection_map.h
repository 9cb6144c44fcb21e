// Aims caustic photons at specular objects, World::targets: by cones from a point of a light, or discs perpendicular to
// parallel light [Jensen01].
#pragma once

#include "reference/lights/lights.h"

#include <cstdint>

namespace hyalite::reference {

// Like emitPhoton, but only rays towards the targets; needs at least one target. The flux of a photon is the light's
// emission along its ray divided by the sampling density; 0 where the light does not emit.
[[nodiscard]] Emission emitAimedPhoton(const World& world, std::uint32_t photon, const PhotonPass& pass,
                                       double shift = 0);

} // namespace hyalite::reference
