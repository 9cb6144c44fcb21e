// Quadrics in world space: not the ray is transformed but the form, Q' = M^-T Q M^-1 [Goldman83], written about a point
// near the surface; then a quadratic in t, and slabs for the clip box.
#pragma once

#include "reference/shapes/affine.h"
#include "reference/shapes/ray.h"
#include "scene/model/scene.h"

#include <glm/glm.hpp>

namespace hyalite::reference {

struct WorldQuadric {
    explicit WorldQuadric(const Quadric& quadric);

    // At the world point center + y
    [[nodiscard]] double value(const glm::dvec3& y) const { return glm::dot(y, A * y + 2.0 * b) + j; }
    [[nodiscard]] glm::dvec3 halfGradient(const glm::dvec3& y) const { return A * y + b; }
    [[nodiscard]] glm::dvec3 objectPoint(const glm::dvec3& y) const { return objectCenter + toObject * y; }

    glm::dvec3 center; // world [m]
    glm::dmat3 A;      // q(center + y) = y^T A y + 2 b.y + j
    glm::dvec3 b;
    double j = 0;
    glm::dvec3 objectCenter; // the same point as center, in object space
    glm::dmat3 toObject;     // object space from world directions
    Bounds clip;             // object space
    bool open = false;       // the clip box only cuts the surface of q, and nothing closes it
};

// Of a solid the complete list; of an open surface where the line passes it within the clip box, entering where it
// comes from the side of q > 0.
[[nodiscard]] Crossings crossings(const WorldQuadric& quadric, const Ray& line);

// Nothing is inside an open surface.
[[nodiscard]] bool isInside(const WorldQuadric& quadric, const glm::dvec3& point);

[[nodiscard]] SurfacePoint surfaceAt(const WorldQuadric& quadric, const Ray& ray, const ShapeHit& hit);

} // namespace hyalite::reference
