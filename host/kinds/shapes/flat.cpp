#include "kinds/shapes/flat.h"

#include "scene/model/scene_limits.h"

#include <utility>

namespace hyalite::kinds {

void transformAxes(const glm::dmat4& map, glm::dvec3& axis0, glm::dvec3& axis1) {
    const glm::dmat3 linear(map);
    axis0 = linear * axis0;
    axis1 = linear * axis1;
    if (glm::determinant(linear) < 0) {
        std::swap(axis0, axis1);
    }
}

bool areParallel(const glm::dvec3& a, const glm::dvec3& b) {
    return !(glm::length(glm::cross(glm::normalize(a), glm::normalize(b))) >= kSmallestAngle);
}

} // namespace hyalite::kinds
