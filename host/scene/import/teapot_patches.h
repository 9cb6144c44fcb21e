// The Utah teapot: the bicubic Bezier patches that Martin Newell drew in 1975 [Crow87], with rim and bottom, as the
// table of 306 points and 32 patches that circulated since. (Some copies open the lid's tip by 0.002; closed here.)
//
// Of each patch the control points are kept once. Rim, body, lid and bottom are the same in all four quarters around
// the axis, handle and spout on both sides of the plane y = 0: 10 patches stand for the 32.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace hyalite {

enum class TeapotPart { Body, Lid, Handle, Spout }; // rim and bottom belong to the body

// Control points in rows of four: u runs from the first row to the last, v along the rows, and dp/dv x dp/du points
// out of the pot. In the data's own space: z up, the bottom at z = 0, the spout towards +x.
struct BicubicPatch {
    TeapotPart part = TeapotPart::Body;
    std::array<std::array<glm::dvec3, 4>, 4> points{};
};

// All 32. Neighbours share the control points of their common edge, in the same order.
[[nodiscard]] std::vector<BicubicPatch> teapotPatches();

} // namespace hyalite
