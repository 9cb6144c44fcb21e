// Progressive photon mapping with independent passes [Knaus11].
#pragma once

#include "image/image.h"
#include "reference/photon_map.h"
#include "reference/render.h"
#include "reference/world.h"

#include <cstdint>

namespace hyalite::reference {

// Radiance [W/(m^2 sr)] through a pixel in a pass, estimated with the pass's photons and search radius [m].
[[nodiscard]] glm::dvec3 ppmRadiance(const World& world, const PhotonMap& photons, double radius, std::uint32_t pixel,
                                     std::uint32_t pass);

// Squared search radius [m^2] of the pass after `pass` (counted from 0), given the squared radius of that pass.
[[nodiscard]] double nextRadius2(double radius2, std::uint32_t pass, double alpha);

[[nodiscard]] LayeredImage renderPpm(const World& world, const RenderOptions& options);

} // namespace hyalite::reference
