// The same paths by the reference, in double precision from their start.
#pragma once

#include "parity/sides.h"
#include "parity/vertex.h"

namespace hyalite::parity {

// To the first diffuse surface on every branch, in the order of depth.
[[nodiscard]] std::vector<Vertex> twinCameraPath(const Sides& sides, std::uint32_t pixel, std::uint32_t pass);

[[nodiscard]] std::vector<Vertex> twinPhotonPath(const Sides& sides, std::uint32_t photon,
                                                 const reference::PhotonPass& pass);

// The random numbers that the choices at a vertex may use, with what each pair is for.
struct RandomNumbers {
    std::string_view purpose;
    glm::dvec2 numbers;
};
[[nodiscard]] std::vector<RandomNumbers> randomNumbersAt(const PathKey& path, const Vertex& vertex);

} // namespace hyalite::parity
