// The Utah teapot as a mesh.
#pragma once

#include "scene/model/scene.h"

#include <cstdint>

namespace hyalite {

inline constexpr std::uint32_t kHighestTeapotLevel = 1024; // 67 million triangles

// Each of the 32 patches cut into level x level quads of two triangles, those of no area at the tip of the lid and in
// the middle of the bottom left out: 64 level^2 - 8 level triangles. Level 6 makes the 2 256 of the classic model.
//
// Newell's units are taken for metres: y up, standing on y = 0 about the y axis, 3.15 high, from the handle at x = -3
// to the spout at x = 3.43; normals are those of the patches. Within body, lid, handle and spout the patches share
// their vertices. Like the original it is not closed: the lid lies in the rim without touching it, and handle and
// spout end inside the body.
//
// Contract: 1 <= level <= kHighestTeapotLevel.
[[nodiscard]] Mesh makeTeapot(std::uint32_t level);

} // namespace hyalite
