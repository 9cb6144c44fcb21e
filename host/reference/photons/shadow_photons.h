// Shadow photons: which lights a place sees, told by the photons that reached it and by those that something stopped
// on the way [JensenChristensen95].
#pragma once

#include "reference/lights/lights.h"
#include "reference/photons/photon_map.h"

#include <cstdint>

namespace hyalite::reference {

// Photons of all lights, followed straight on through everything: on diffuse surfaces each leaves a direct photon where
// it lands first and shadow photons, without power, behind that. Ascending by (photon, depth).
[[nodiscard]] std::vector<Photon> castShadowPhotons(const World& world, std::uint32_t pass);

// What is known of the lights from a place, bit by bit.
struct Visibility {
    std::uint32_t lit = 0;      // bit i: light i is seen
    std::uint32_t shadowed = 0; // bit i: it is not
};

// A light is known where `agreeing` of its photons or more are among the nearest within `radius` [m], all direct or all
// shadow photons. Looked at are `agreeing` photons per light, up to the limit of an estimate.
[[nodiscard]] Visibility classifyVisibility(const PhotonMap& map, const VisiblePoint& x, std::uint32_t lights,
                                            std::uint32_t agreeing, double radius);

} // namespace hyalite::reference
