// Quadrics in world space: transforms the quadratic form instead of the ray, Q' = M^-T Q M^-1 [Goldman83], about a
// point near the surface; then solves a quadratic in t, with slabs for the clip box.
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
    glm::dvec3 objectCenter; // center in object space
    glm::dmat3 toObject;     // from world directions to object space
    Bounds clip;             // object space
    bool open = false;       // the clip box only cuts the surface of q and does not close it
};

// The complete list for a solid. For an open surface, where the line crosses it within the clip box; entering if the
// line comes from the side q > 0.
[[nodiscard]] Crossings crossings(const WorldQuadric& quadric, const Ray& line);

// Nothing is inside an open surface.
[[nodiscard]] bool isInside(const WorldQuadric& quadric, const glm::dvec3& point);

[[nodiscard]] SurfacePoint surfaceAt(const WorldQuadric& quadric, const Ray& ray, const ShapeHit& hit);

} // namespace hyalite::reference
