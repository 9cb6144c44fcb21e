// One vertex of a path, on either side.
#pragma once

#include "parity/sides.h"

#include "shaders/shared/limits.h"
#include "shaders/shared/media.h"
#include "shaders/shared/path_records.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace hyalite::parity {

// What happened at a vertex, as bits.
inline constexpr std::uint32_t kDiffuse = 1;     // camera path: a visible point
inline constexpr std::uint32_t kReflected = 2;   // continues on the side that it came from
inline constexpr std::uint32_t kTransmitted = 4; // continues on the other side
inline constexpr std::uint32_t kStored = 8;      // photon path: stores a photon
inline constexpr std::uint32_t kBounced = 16;    // camera path: continues from the diffuse surface

struct Vertex {
    std::uint32_t seed = 0;  // camera path: of its sampler, which identifies the branch
    std::uint32_t depth = 0; // segments from the start to here
    glm::dvec3 from{0};      // where the segment starts [m]
    glm::dvec3 direction{0}; // unit
    glm::dvec3 position{0};  // world [m]; zero if the segment hits nothing
    glm::dvec3 normal{0};    // unit, on the side the path came from
    bool front = false;
    std::uint32_t object = shared::kNone;   // of the scene; kNone: nothing was hit
    std::uint32_t primitive = 0;            // see reference::Hit
    std::uint32_t material = shared::kNone; // of the scene
    std::uint32_t media = shared::kNoMedia; // around the segment, as a word of the device
    std::uint32_t medium = shared::kNone;   // the material of these media
    glm::dvec3 weight{0};                   // camera path: throughput; photon: flux [W]; along the segment
    double pdfW = 0;                        // camera path: of the segment's direction [1/sr]; 0: none
    std::uint32_t choice = 0;               // k… above
};

// The device's vertex also keeps its inputs.
struct DeviceVertex : Vertex {
    shared::Ray ray{};
    shared::Hit hit{};
    std::uint32_t photonKind = 0; // photon path
    std::uint32_t light = 0;      // photon path: the light that emitted it
};

// Identifies a path: of a pixel in a pass, or of a photon in a sequence.
struct PathKey {
    bool isPhoton = false;
    std::uint32_t sequence = 0;                       // pass, or seed of the photons' samplers
    std::uint32_t number = 0;                         // pixel or photon
    auto operator<=>(const PathKey&) const = default; // NOLINT(modernize-use-nullptr): it compares with no 0
};

[[nodiscard]] std::string describeChoice(const Vertex& vertex);

// Sets the surface hit by the vertex's segment.
void setSurface(Vertex& vertex, const Sides& sides, const reference::Hit& hit, const reference::Surface& surface);

// kReflected or kTransmitted, for a ray that continues from this surface.
[[nodiscard]] std::uint32_t continuation(const reference::Surface& surface, const glm::dvec3& direction);

} // namespace hyalite::parity
