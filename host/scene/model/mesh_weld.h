// Finds the vertices of a mesh with equal positions: files and smooth normals repeat positions.
#pragma once

#include "scene/model/scene.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace hyalite {

// For each position the index of the first equal one (0 equals -0). Positions must be finite and fewer than 2^31.
[[nodiscard]] std::vector<std::uint32_t> weldPositions(std::span<const glm::vec3> positions);
[[nodiscard]] std::vector<std::uint32_t> weldPositions(std::span<const glm::dvec3> positions);

// Merges equal positions of a mesh without other per-vertex data; the remaining positions keep their order.
void weldVertices(Mesh& mesh);

} // namespace hyalite
