// Surfaces of second degree: the coefficients of the named forms, their transforms, and how far they reach.
#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

namespace hyalite {

// The symmetric matrix Q with q(p) = (p, 1)^T Q (p, 1), and back [Goldman83].
[[nodiscard]] glm::dmat4 quadricMatrix(const QuadricForm& form);
[[nodiscard]] QuadricForm quadricForm(const glm::dmat4& symmetric);

// The form of the image of the surface under an invertible affine map: Q' = M^-T Q M^-1.
[[nodiscard]] QuadricForm transformed(const QuadricForm& form, const glm::dmat4& map);

[[nodiscard]] double evaluate(const QuadricForm& form, const glm::dvec3& point);

// Half the gradient of q.
[[nodiscard]] glm::dvec3 halfGradient(const QuadricForm& form, const glm::dvec3& point);

// A box around {q <= 0} alone: exact where that is an ellipsoid, with infinite sides along the axes in which an
// elliptic cylinder along an axis has no end, and everything otherwise.
[[nodiscard]] Bounds formBounds(const QuadricForm& form);

// A box around the shape, in object space and in world space.
[[nodiscard]] Bounds objectBounds(const Quadric& quadric);
[[nodiscard]] Bounds worldBounds(const Quadric& quadric);

// The smallest box around the image of a box.
[[nodiscard]] Bounds transformed(const Bounds& box, const glm::dmat4& map);

// Points that lie in both boxes; empty (low > high along some axis) where there are none.
[[nodiscard]] Bounds intersection(const Bounds& a, const Bounds& b);

// The point that q is best written about: where its gradient vanishes, or nearly does (the least squares solution of
// smallest norm, for forms without such a point).
[[nodiscard]] glm::dvec3 formCenter(const QuadricForm& form);

// The half-space behind a plane.
[[nodiscard]] Quadric halfSpace(const Plane& plane);

} // namespace hyalite
