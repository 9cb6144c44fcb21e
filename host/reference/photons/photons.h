// Photon tracing: flux carried from the lights and stored wherever it lands on a diffuse surface after at least one
// bounce [Jensen01].
#pragma once

#include "reference/world.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hyalite::reference {

// Kind of a photon on a diffuse surface, by the path it took there.
enum class PhotonKind : std::uint8_t {
    Direct,   // straight from the light
    Indirect, // via a diffuse surface
    Caustic,  // via mirrors and glass only
    Shadow    // the light is occluded from this place; no power
};

struct PhotonPath {
    glm::dvec3 power;                     // flux [W], light pmf and photon count divided out
    std::uint32_t photon = 0;             // number of the photon in its pass
    std::uint32_t light = 0;              // index of the emitting light
    PhotonKind kind = PhotonKind::Direct; // of the photon that this path would store on a diffuse surface
    Media media = {};                     // around the ray
};

// Which photons a pass emits and stores.
struct PhotonPass {
    std::uint32_t sequence = 0; // see shared::photonSequence
    std::uint32_t count = 0;    // emitted
    std::uint32_t kinds = 0;    // bit PhotonKind is set for every kind to store; paths that cannot store any more end
    bool aimed = false;         // emits only towards World::targets, see projection_map.h
};

[[nodiscard]] constexpr std::uint32_t kindBit(PhotonKind kind) {
    return 1U << static_cast<std::uint32_t>(kind);
}

// The photons of progressive photon mapping: all but the direct ones, which shadow rays replace.
[[nodiscard]] PhotonPass progressivePass(const World& world, std::uint32_t pass);

// A stored photon.
struct Photon {
    glm::dvec3 position;      // world [m]
    glm::dvec3 direction;     // unit, towards its origin
    glm::dvec3 normal;        // unit, geometric, on the side of arrival
    glm::dvec3 power;         // flux [W], where a smoothed normal counts: by the cosine at that
    std::uint32_t photon = 0; // number in its pass
    std::uint32_t depth = 0;  // segments from the light to here
    std::uint32_t light = 0;  // index of the emitting light
    PhotonKind kind = PhotonKind::Indirect;
    double discRadius = 0; // of an irradiance record: of the disc of its estimate [m]
};

struct PhotonScatter {
    std::optional<Photon> stored;
    std::optional<Ray> next; // none: absorbed, or at the length limit that camera paths can use
    PhotonPath path;         // along the next ray
};

// A photon at a hit, `depth` segments from the light: stored on a diffuse surface if its kind is wanted, then scattered
// or absorbed by Russian roulette.
[[nodiscard]] PhotonScatter scatterPhoton(const World& world, const Ray& ray, const Hit& hit, const PhotonPath& path,
                                          std::uint32_t depth, const PhotonPass& pass);

// All photons stored in a pass, ascending by (photon, depth).
[[nodiscard]] std::vector<Photon> tracePhotons(const World& world, const PhotonPass& pass);

// The lists concatenated.
[[nodiscard]] std::vector<Photon> joined(const std::vector<std::vector<Photon>>& blocks);

} // namespace hyalite::reference
