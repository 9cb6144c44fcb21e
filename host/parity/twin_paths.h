// The same paths by the reference, in double precision from their start.
#pragma once

#include "parity/nudge.h"
#include "parity/path_step.h"

namespace hyalite::parity {

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
