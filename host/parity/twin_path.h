// A path in the double-precision reference: one step (hit, choice, next ray), and all steps from its start.
#pragma once

#include "parity/nudge.h"
#include "parity/sides.h"
#include "parity/vertex.h"

#include <optional>
#include <string_view>
#include <vector>

namespace hyalite::parity {

// A path between two vertices.
struct PathState {
    reference::Ray ray;
    reference::CameraPath camera; // for camera paths
    reference::PhotonPath photon; // for photon paths
    std::uint32_t depth = 1;      // of the next vertex
};

// State in which the device's path arrived at a vertex.
[[nodiscard]] PathState stateBefore(const Sides& sides, const PathKey& key, const DeviceVertex& vertex);

struct PathStep {
    Vertex vertex;
    std::vector<PathState> next; // at most two
};

// `hit`: hit of the ray. `pass`: for photon paths.
[[nodiscard]] PathStep stepOf(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass,
                              const PathState& state, const std::optional<reference::Hit>& hit);

// Start of a path; for photons, with random numbers moved by the nudge. `pass`: for photon paths.
[[nodiscard]] PathState firstState(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass,
                                   Nudge nudge);

// Follows camera paths to the first diffuse surface on every branch (the path tracer's to their end), and photon paths
// until they are absorbed or too long for any camera path. Ordered by depth.
[[nodiscard]] std::vector<Vertex> twinPath(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass);

// The random numbers available to the choices at a vertex, with the purpose of each pair.
struct RandomNumbers {
    std::string_view purpose;
    glm::dvec2 numbers;
};
[[nodiscard]] std::vector<RandomNumbers> randomNumbersAt(std::string_view integrator, const PathKey& path,
                                                         const Vertex& vertex);

} // namespace hyalite::parity
