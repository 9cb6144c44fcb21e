// A shape's own space and the world's, either way; the translation is kept apart, so that points near a shape keep
// their digits however far from the origin it stands.
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
    // By the inverse transpose; not normalised.
    [[nodiscard]] glm::dvec3 normalToWorld(const glm::dvec3& n) const { return glm::transpose(inverse) * n; }
    // The direction is not normalised, so that t means the same in both spaces.
    [[nodiscard]] Ray rayToObject(const Ray& ray) const {
        return {.origin = pointToObject(ray.origin), .direction = inverse * ray.direction, .tMax = ray.tMax};
    }
};

// Square root of the sum of the squares of all elements: at least the matrix's largest stretch, at most sqrt 3 times.
[[nodiscard]] inline double frobeniusNorm(const glm::dmat3& m) {
    return glm::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

// The scale for surfaceOffset at a world point of a shape that is intersected in object space: `objectScale` [object
// units] bounds the lengths that are added up there, `objectNormal` is of any length.
[[nodiscard]] inline double roundingScale(const Affine& map, const glm::dvec3& point, double objectScale,
                                          const glm::dvec3& objectNormal) {
    // Object coordinates are rounded in the map of the point and in the intersection; how far that moves the surface in
    // the world is the distance of two planes n.x = const that lie this far apart in object space.
    const glm::dvec3 arm = point - map.translation;
    const double inObject = objectScale + frobeniusNorm(map.inverse) * glm::length(arm);
    const double toWorld = glm::length(objectNormal) / glm::length(map.normalToWorld(objectNormal));
    return glm::length(map.translation) + glm::length(arm) + inObject * toWorld;
}

} // namespace hyalite::reference
