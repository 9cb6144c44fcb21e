// Quadrics, surfaces of second degree: coefficients, transforms, extremes and bounds.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>

namespace hyalite {

// The symmetric matrix Q with q(p) = (p, 1)^T Q (p, 1), and back [Goldman83].
[[nodiscard]] glm::dmat4 quadricMatrix(const QuadricForm& form);
[[nodiscard]] QuadricForm quadricForm(const glm::dmat4& symmetric);

// A and b of q(p) = p^T A p + 2 b^T p + j.
[[nodiscard]] glm::dmat3 quadraticPart(const QuadricForm& form);
[[nodiscard]] glm::dvec3 linearPart(const QuadricForm& form);

// The form of the image of the surface under an invertible affine map: Q' = M^-T Q M^-1.
[[nodiscard]] QuadricForm transformed(const QuadricForm& form, const glm::dmat4& map);

[[nodiscard]] double evaluate(const QuadricForm& form, const glm::dvec3& point);

// Half the gradient of q.
[[nodiscard]] glm::dvec3 halfGradient(const QuadricForm& form, const glm::dvec3& point);

// The form divided by its largest coefficient's magnitude, which leaves the shape unchanged. Not all may be 0.
[[nodiscard]] QuadricForm normalised(const QuadricForm& form);

// A box around {q <= 0}, without a clip box: exact for an ellipsoid, infinite along the axis of an elliptic cylinder
// parallel to an axis, and everything otherwise.
[[nodiscard]] Bounds formBounds(const QuadricForm& form);

// A box around the shape, in object space and in world space: also finite if the clip box bounds the shape along one
// axis and its cross-sections are ellipses.
[[nodiscard]] Bounds objectBounds(const Quadric& quadric);
[[nodiscard]] Bounds worldBounds(const Quadric& quadric);

// The smallest box around the image of a box.
[[nodiscard]] Bounds transformed(const Bounds& box, const glm::dmat4& map);

// The shape with a clip box that is finite wherever the shape is bounded. An added side lies a little outside the shape
// and does not touch it. A clip box without any side is kept: the surface of q is then closed by itself.
[[nodiscard]] Quadric withFiniteClip(Quadric quadric);

// The intersection of two boxes; empty (low > high along some axis) if they do not meet.
[[nodiscard]] Bounds intersection(const Bounds& a, const Bounds& b);
[[nodiscard]] bool isEmpty(const Bounds& box);

// The best origin for the coefficients of q: the centre of an ellipsoid, hyperboloid or pair of planes, the vertex of a
// cone or paraboloid; if the centre is a line or plane, its point nearest to the origin; likewise for a plane.
[[nodiscard]] glm::dvec3 formCenter(const QuadricForm& form);

// The least and the greatest value of q within a box.
struct Extremes {
    double least = 0;
    double greatest = 0;
};
[[nodiscard]] Extremes extremes(const QuadricForm& form, const Bounds& finite);

// Eigenvectors (columns, orthonormal) and eigenvalues of a symmetric matrix.
struct Eigensystem {
    glm::dmat3 vectors{1.0};
    glm::dvec3 values{0};
};
[[nodiscard]] Eigensystem eigensystem(glm::dmat3 symmetric);

// The half-space behind a plane.
[[nodiscard]] Quadric halfSpace(const Plane& plane);

} // namespace hyalite
