// Photon tracing: flux carried from the lights, stored wherever it lands on a diffuse surface after at least one bounce
// [Jensen01].
#pragma once

#include "reference/world.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hyalite::reference {

// What a photon that lands on a diffuse surface is called, by the way it came.
enum class PhotonKind : std::uint8_t {
    Direct,   // straight from the light
    Indirect, // by way of a diffuse surface
    Caustic,  // by way of mirrors and glass alone
    Shadow    // something stands between the light and this place; no power
};

struct PhotonPath {
    glm::dvec3 power;                     // flux [W], light pmf and photon count divided out
    std::uint32_t photon = 0;             // number of the photon in its pass
    std::uint32_t light = 0;              // that emitted it
    PhotonKind kind = PhotonKind::Direct; // of the photon that it would leave on a diffuse surface
    const Material* medium = nullptr;     // of the world: the dielectric that it runs in; nullptr: none
};

// The photons of one purpose and one pass.
struct PhotonPass {
    std::uint32_t sequence = 0; // see shared::photonSequence
    std::uint32_t count = 0;    // emitted
    std::uint32_t kinds = 0;    // bit PhotonKind is set for every kind that is stored; paths that can store no more end
    bool aimed = false;         // emit only towards World::targets, see projection_map.h
};

[[nodiscard]] constexpr std::uint32_t kindBit(PhotonKind kind) {
    return 1U << static_cast<std::uint32_t>(kind);
}

// Those of progressive photon mapping: all but the direct ones, which shadow rays stand for.
[[nodiscard]] PhotonPass progressivePass(const World& world, std::uint32_t pass);

// A stored photon.
struct Photon {
    glm::dvec3 position;      // world [m]
    glm::dvec3 direction;     // unit, towards where it came from
    glm::dvec3 normal;        // unit, shading normal of the surface it landed on, on the side it came from
    glm::dvec3 power;         // flux [W]
    std::uint32_t photon = 0; // number in its pass
    std::uint32_t depth = 0;  // segments from the light to here
    std::uint32_t light = 0;  // that emitted it
    PhotonKind kind = PhotonKind::Indirect;
};

struct PhotonScatter {
    std::optional<Photon> stored;
    std::optional<Ray> next; // none: absorbed, or the path is as long as any camera path could use
    PhotonPath path;         // along the next ray
};

// What becomes of a photon at a hit, `depth` segments from the light: stored on a diffuse surface if its kind is
// wanted, then scattered or absorbed by Russian roulette.
[[nodiscard]] PhotonScatter scatterPhoton(const World& world, const Ray& ray, const Hit& hit, const PhotonPath& path,
                                          std::uint32_t depth, const PhotonPass& pass);

// All photons stored in a pass, ascending by (photon, depth).
[[nodiscard]] std::vector<Photon> tracePhotons(const World& world, const PhotonPass& pass);

// The lists one after the other.
[[nodiscard]] std::vector<Photon> joined(const std::vector<std::vector<Photon>>& blocks);

} // namespace hyalite::reference
