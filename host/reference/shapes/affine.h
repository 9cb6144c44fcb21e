// Maps between object space and world space. The translation is kept apart, so that points near a shape keep their
// precision however far from the origin it is.
#pragma once

#include "reference/shapes/ray.h"

#include <glm/glm.hpp>

namespace hyalite::reference {

struct Affine {
    glm::dmat3 linear{1.0};
    glm::dmat3 inverse{1.0};   // of linear
    glm::dvec3 translation{0}; // [m]

    Affine() = default;
    explicit Affine(const glm::dmat4& objectToWorld)
        : linear(objectToWorld), inverse(glm::inverse(linear)), translation(objectToWorld[3]) {}

    [[nodiscard]] glm::dvec3 pointToWorld(const glm::dvec3& p) const { return linear * p + translation; }
    [[nodiscard]] glm::dvec3 pointToObject(const glm::dvec3& p) const { return inverse * (p - translation); }
    // Inverse transpose; the result is not normalised.
    [[nodiscard]] glm::dvec3 normalToWorld(const glm::dvec3& n) const { return glm::transpose(inverse) * n; }
    // The direction is not normalised, so that t is the same in both spaces.
    [[nodiscard]] Ray rayToObject(const Ray& ray) const {
        return {.origin = pointToObject(ray.origin), .direction = inverse * ray.direction, .tMax = ray.tMax};
    }
};

// Square root of the sum of the squares of all elements: between one and sqrt 3 times the largest singular value.
[[nodiscard]] inline double frobeniusNorm(const glm::dmat3& m) {
    return glm::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

// The scale for surfaceOffset at a world point of a shape that is intersected in object space: `objectScale` [object
// units] bounds the lengths added up there; `objectNormal` may have any length.
[[nodiscard]] inline double roundingScale(const Affine& map, const glm::dvec3& point, double objectScale,
                                          const glm::dvec3& objectNormal) {
    // Mapping the point and intersecting both round object coordinates. The surface moves in the world by the distance
    // of two planes n.x = const that lie this rounding error apart in object space.
    const glm::dvec3 arm = point - map.translation;
    const double inObject = objectScale + frobeniusNorm(map.inverse) * glm::length(arm);
    const double toWorld = glm::length(objectNormal) / glm::length(map.normalToWorld(objectNormal));
    return glm::length(map.translation) + glm::length(arm) + inObject * toWorld;
}

} // namespace hyalite::reference
