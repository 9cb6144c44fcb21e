// Photon tracing: flux carried from the lights, stored wherever it lands on a diffuse surface after at least one bounce
// [Jensen01].
#pragma once

#include "reference/world.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hyalite::reference {

struct PhotonPath {
    glm::dvec3 power;         // flux [W], light pmf and photon count divided out
    std::uint32_t photon = 0; // number of the photon in its pass
};

// A stored photon.
struct Photon {
    glm::dvec3 position;      // world [m]
    glm::dvec3 direction;     // unit, towards where it came from
    glm::dvec3 normal;        // unit, shading normal of the surface it landed on, on the side it came from
    glm::dvec3 power;         // flux [W]
    std::uint32_t photon = 0; // number in its pass
    std::uint32_t depth = 0;  // segments from the light to here
};

struct PhotonScatter {
    std::optional<Photon> stored;
    std::optional<Ray> next; // none: absorbed, or the path is as long as any camera path could use
    PhotonPath path;         // along the next ray
};

// What becomes of a photon at a hit, `depth` segments from the light: stored on a diffuse surface unless it came
// straight from the light (shadow rays bring that), then scattered or absorbed by Russian roulette.
[[nodiscard]] PhotonScatter scatterPhoton(const World& world, const Ray& ray, const Hit& hit, const PhotonPath& path,
                                          std::uint32_t depth, std::uint32_t pass);

// All photons stored in a pass, ascending by (photon, depth).
[[nodiscard]] std::vector<Photon> tracePhotons(const World& world, std::uint32_t pass);

} // namespace hyalite::reference
