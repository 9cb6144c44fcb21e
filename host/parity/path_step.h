// One step of a path by the reference: what its ray meets, what is chosen there, and how it goes on.
#pragma once

#include "parity/sides.h"
#include "parity/vertex.h"

#include <optional>
#include <vector>

namespace hyalite::parity {

// A path on its way to its next vertex.
struct PathState {
    reference::Ray ray;
    reference::CameraPath camera; // a camera path's
    reference::PhotonPath photon; // a photon path's
    std::uint32_t depth = 1;      // of the vertex
};

// As the device's path came to a vertex.
[[nodiscard]] PathState stateBefore(const Sides& sides, const PathKey& key, const DeviceVertex& vertex);

struct PathStep {
    Vertex vertex;
    std::vector<PathState> next; // at most two
};

// `hit`: what the ray meets. `pass`: a photon path's.
[[nodiscard]] PathStep stepOf(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass,
                              const PathState& state, const std::optional<reference::Hit>& hit);

} // namespace hyalite::parity
