// The quadrics that have names, about their own centres with y as their axis. Each is q <= 0 inside, and its largest
// coefficient has magnitude 1.
#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

namespace hyalite {

// No surface of its own, only the faces of its clip box.
[[nodiscard]] Quadric boxQuadric(const glm::dvec3& halfSize);

// Solids with caps from a base at the world's origin to a top at `height` on the y axis. Their object space is about
// the cylinder's middle, and about the cone's smaller end: a point, or near it where q would lose digits.
[[nodiscard]] Quadric cylinderQuadric(double radius, double height);
[[nodiscard]] Quadric coneQuadric(double baseRadius, double topRadius, double height);

// x^2/a^2 + y^2/b^2 + z^2/c^2 <= 1 with radii a, b, c
[[nodiscard]] QuadricForm ellipsoidForm(const glm::dvec3& radii);

} // namespace hyalite
