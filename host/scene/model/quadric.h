// Surfaces of second degree: the coefficients of the named forms, their transforms, and how far they reach.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>

namespace hyalite {

// The symmetric matrix Q with q(p) = (p, 1)^T Q (p, 1), and back [Goldman83].
[[nodiscard]] glm::dmat4 quadricMatrix(const QuadricForm& form);
[[nodiscard]] QuadricForm quadricForm(const glm::dmat4& symmetric);

// Of q(p) = p^T A p + 2 b^T p + j, A and b.
[[nodiscard]] glm::dmat3 quadraticPart(const QuadricForm& form);
[[nodiscard]] glm::dvec3 linearPart(const QuadricForm& form);

// The form of the image of the surface under an invertible affine map: Q' = M^-T Q M^-1.
[[nodiscard]] QuadricForm transformed(const QuadricForm& form, const glm::dmat4& map);

[[nodiscard]] double evaluate(const QuadricForm& form, const glm::dvec3& point);

// Half the gradient of q.
[[nodiscard]] glm::dvec3 halfGradient(const QuadricForm& form, const glm::dvec3& point);

// The same set and surface: divided by the largest coefficient's magnitude. Some coefficient must not be 0.
[[nodiscard]] QuadricForm normalised(const QuadricForm& form);

// A box around {q <= 0} alone: exact where that is an ellipsoid, with infinite sides along the axes in which an
// elliptic cylinder along an axis has no end, and everything otherwise.
[[nodiscard]] Bounds formBounds(const QuadricForm& form);

// A box around the shape, in object space and in world space: finite too where the clip box ends the shape along one
// axis and q, across it, is an ellipse.
[[nodiscard]] Bounds objectBounds(const Quadric& quadric);
[[nodiscard]] Bounds worldBounds(const Quadric& quadric);

// The smallest box around the image of a box.
[[nodiscard]] Bounds transformed(const Bounds& box, const glm::dmat4& map);

// The shape with a clip box that is finite wherever the shape itself ends. Where it had no side and the shape needs
// none, the new one lies a little outside and touches nothing. A clip box without sides stays: it leaves the surface
// closed.
[[nodiscard]] Quadric withFiniteClip(Quadric quadric);

// Points that lie in both boxes; empty (low > high along some axis) where there are none.
[[nodiscard]] Bounds intersection(const Bounds& a, const Bounds& b);
[[nodiscard]] bool isEmpty(const Bounds& box);

// The point that q is best written about: the centre of an ellipsoid, hyperboloid or pair of planes, the vertex of a
// cone or paraboloid; where these are lines or planes, the point of them nearest to the origin; of a plane too.
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
