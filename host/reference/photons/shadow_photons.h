// Shadow photons: estimates which lights are visible from a place, from the photons that reached it and those that were
// occluded [JensenChristensen95].
#pragma once

#include "reference/lights/lights.h"
#include "reference/photons/photon_map.h"

#include <cstdint>

namespace hyalite::reference {

// Photons of all lights, followed straight through all surfaces: on diffuse surfaces each stores a direct photon at its
// first hit and shadow photons, without power, at the hits behind it. Ascending by (photon, depth).
[[nodiscard]] std::vector<Photon> castShadowPhotons(const World& world, std::uint32_t pass);

// Known visibility of the lights from a place, one bit per light.
struct Visibility {
    std::uint32_t lit = 0;      // bit i: light i is visible
    std::uint32_t shadowed = 0; // bit i: light i is occluded
};

// A light's visibility is known if at least `agreeing` of its photons are among the nearest within `radius` [m], all of
// them direct or all of them shadow photons. Searches `agreeing` photons per light, up to the limit of an estimate.
[[nodiscard]] Visibility classifyVisibility(const PhotonMap& map, const VisiblePoint& x, std::uint32_t lights,
                                            std::uint32_t agreeing, double radius, double surfaceError);

} // namespace hyalite::reference
