// A path in the reference, in double precision: one step (what its ray meets, what is chosen there, how it goes on),
// and all steps from its start.
#pragma once

#include "parity/nudge.h"
#include "parity/sides.h"
#include "parity/vertex.h"

#include <optional>
#include <string_view>
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

// As a path starts; photons, by random numbers that are moved. `pass`: a photon path's.
[[nodiscard]] PathState firstState(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass,
                                   Nudge nudge);

// Camera paths to the first diffuse surface on every branch, those of the path tracer to their end; photon paths until
// they are absorbed or too long for any camera path. In the order of depth.
[[nodiscard]] std::vector<Vertex> twinPath(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass);

// The random numbers that the choices at a vertex may use, with what each pair is for.
struct RandomNumbers {
    std::string_view purpose;
    glm::dvec2 numbers;
};
[[nodiscard]] std::vector<RandomNumbers> randomNumbersAt(std::string_view integrator, const PathKey& path,
                                                         const Vertex& vertex);

} // namespace hyalite::parity
