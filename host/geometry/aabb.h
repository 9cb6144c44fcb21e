// Axis-aligned boxes in single precision, as bounding volumes need them.
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace hyalite {

struct Aabb {
    glm::vec3 lower{std::numeric_limits<float>::infinity()}; // an empty box until something is added
    glm::vec3 upper{-std::numeric_limits<float>::infinity()};

    void add(const glm::vec3& p) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    void add(const Aabb& b) {
        lower = glm::min(lower, b.lower);
        upper = glm::max(upper, b.upper);
    }
    [[nodiscard]] bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
    [[nodiscard]] glm::vec3 extent() const { return empty() ? glm::vec3(0) : upper - lower; }
    [[nodiscard]] glm::vec3 center() const { return 0.5F * lower + 0.5F * upper; }
    // Half the surface area: a surface-area heuristic only compares ratios.
    [[nodiscard]] float halfArea() const {
        const glm::vec3 e = extent();
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
};

} // namespace hyalite
