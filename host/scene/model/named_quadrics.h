// The named quadrics, centred at the origin with axis y. q <= 0 inside; the largest coefficient has magnitude 1.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>

namespace hyalite {

// The faces of its clip box are its only surface.
[[nodiscard]] Quadric boxQuadric(const glm::dvec3& halfSize);

// Capped solids from a base at the world's origin to a top at `height` on the y axis. The origin of object space is the
// cylinder's middle or the cone's smaller end: at or near the apex, where q would otherwise lose digits.
[[nodiscard]] Quadric cylinderQuadric(double radius, double height);
[[nodiscard]] Quadric coneQuadric(double baseRadius, double topRadius, double height);

// Without caps or clip box. The radii a, b, c [m] are lengths along x, y and z.
[[nodiscard]] QuadricForm ellipsoidForm(const glm::dvec3& radii);            // x^2/a^2 + y^2/b^2 + z^2/c^2 <= 1
[[nodiscard]] QuadricForm paraboloidForm(const glm::dvec3& radii);           // x^2/a^2 + z^2/c^2 <= y/b
[[nodiscard]] QuadricForm hyperboloidOneSheetForm(const glm::dvec3& radii);  // x^2/a^2 - y^2/b^2 + z^2/c^2 <= 1
[[nodiscard]] QuadricForm hyperboloidTwoSheetsForm(const glm::dvec3& radii); // x^2/a^2 - y^2/b^2 + z^2/c^2 <= -1
[[nodiscard]] QuadricForm hyperbolicParaboloidForm(const glm::dvec3& radii); // x^2/a^2 - z^2/c^2 >= y/b

} // namespace hyalite
