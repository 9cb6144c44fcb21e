// Bounding box of the twin's results over all nearby inputs that led to the same decisions.
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace hyalite::parity {

class Hull {
public:
    void add(const glm::dvec3& v) {
        low_ = glm::min(low_, v);
        high_ = glm::max(high_, v);
    }
    [[nodiscard]] const glm::dvec3& high() const { return high_; }
    // Tests the box widened on each side by its own extent and the tolerance.
    [[nodiscard]] bool holds(const glm::dvec3& v, double tolerance) const {
        const glm::dvec3 margin = (high_ - low_) + glm::dvec3(tolerance);
        return glm::all(glm::greaterThanEqual(v, low_ - margin)) && glm::all(glm::lessThanEqual(v, high_ + margin));
    }

private:
    glm::dvec3 low_{std::numeric_limits<double>::infinity()};
    glm::dvec3 high_{-std::numeric_limits<double>::infinity()};
};

} // namespace hyalite::parity
