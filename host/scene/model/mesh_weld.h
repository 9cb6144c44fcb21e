// Which vertices of a mesh stand in the same place: files and smooth normals repeat positions.
#pragma once

#include "scene/model/scene.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace hyalite {

// For each position the index of the first one of equal value (0 equals -0); positions are finite, fewer than 2^31.
[[nodiscard]] std::vector<std::uint32_t> weldPositions(std::span<const glm::vec3> positions);

// Merges positions of equal value in a mesh that has nothing else per position; the first of them keep their order.
void weldVertices(Mesh& mesh);

} // namespace hyalite
