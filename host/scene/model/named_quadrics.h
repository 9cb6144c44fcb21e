// The quadrics that have names, about their own centres with y as their axis. Each is q <= 0 inside, and its largest
// coefficient has magnitude 1.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>

namespace hyalite {

// No surface of its own, only the faces of its clip box.
[[nodiscard]] Quadric boxQuadric(const glm::dvec3& halfSize);

// Solids with caps from a base at the world's origin to a top at `height` on the y axis. Their object space is about
// the cylinder's middle, and about the cone's smaller end: a point, or near it where q would lose digits.
[[nodiscard]] Quadric cylinderQuadric(double radius, double height);
[[nodiscard]] Quadric coneQuadric(double baseRadius, double topRadius, double height);

// Without caps or clip box. The radii a, b, c [m] are lengths along x, y and z.
[[nodiscard]] QuadricForm ellipsoidForm(const glm::dvec3& radii);            // x^2/a^2 + y^2/b^2 + z^2/c^2 <= 1
[[nodiscard]] QuadricForm paraboloidForm(const glm::dvec3& radii);           // x^2/a^2 + z^2/c^2 <= y/b
[[nodiscard]] QuadricForm hyperboloidOneSheetForm(const glm::dvec3& radii);  // x^2/a^2 - y^2/b^2 + z^2/c^2 <= 1
[[nodiscard]] QuadricForm hyperboloidTwoSheetsForm(const glm::dvec3& radii); // x^2/a^2 - y^2/b^2 + z^2/c^2 <= -1
[[nodiscard]] QuadricForm hyperbolicParaboloidForm(const glm::dvec3& radii); // x^2/a^2 - z^2/c^2 >= y/b

} // namespace hyalite
