// See bounding_sphere.h.
#include "geometry/bounding_sphere.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hyalite {
namespace {

struct Farthest {
    double squared = -1; // distance [m^2]
    std::size_t index = 0;
};

Farthest farthestFrom(std::span<const glm::vec3> points, const glm::dvec3& center) {
    constexpr std::size_t kGrain = std::size_t{1} << 17U;
    std::vector<Farthest> found((points.size() + kGrain - 1) / kGrain);
    parallelFor(points.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        Farthest best;
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec3 offset = glm::dvec3(points[i]) - center;
            const double squared = glm::dot(offset, offset);
            if (squared > best.squared) {
                best = {squared, i};
            }
        }
        found[begin / kGrain] = best;
    });
    return *std::max_element(found.begin(), found.end(),
                             [](const Farthest& a, const Farthest& b) { return a.squared < b.squared; });
}

// Of the points that are least or greatest along an axis, the pair that is farthest apart.
std::pair<glm::dvec3, glm::dvec3> widestPair(std::span<const glm::vec3> points) {
    std::pair<glm::dvec3, glm::dvec3> widest{points[0], points[0]};
    for (int axis = 0; axis < 3; ++axis) {
        const auto [low, high] = std::minmax_element(
            points.begin(), points.end(), [axis](const glm::vec3& a, const glm::vec3& b) { return a[axis] < b[axis]; });
        if (glm::distance(glm::dvec3(*low), glm::dvec3(*high)) > glm::distance(widest.first, widest.second)) {
            widest = {*low, *high};
        }
    }
    return widest;
}

// Ritter: the sphere about the widest pair grows to each point that it does not hold, away from the side opposite.
glm::dvec3 ritterCenter(std::span<const glm::vec3> points) {
    const auto [low, high] = widestPair(points);
    glm::dvec3 center = 0.5 * (low + high);
    double radius = 0.5 * glm::distance(low, high);
    for (const glm::vec3& point : points) {
        const glm::dvec3 offset = glm::dvec3(point) - center;
        const double squared = glm::dot(offset, offset);
        if (squared > radius * radius) {
            const double distance = std::sqrt(squared);
            const double grown = 0.5 * (radius + distance);
            center += offset * ((grown - radius) / distance);
            radius = grown;
        }
    }
    return center;
}

} // namespace

BoundingSphere boundingSphere(std::span<const glm::vec3> points) {
    if (points.empty()) {
        return {};
    }
    // From any centre within the points' hull, as Ritter's is, n steps of 1/(i + 1) of the way to the farthest point
    // end within 1/sqrt(n) of the least radius from the best centre: 25 steps promise a radius 20 % above the least.
    constexpr int kSteps = 25;
    BoundingSphere best;
    glm::dvec3 center = ritterCenter(points);
    for (int step = 1;; ++step) {
        const Farthest farthest = farthestFrom(points, center);
        const double radius = std::sqrt(farthest.squared);
        if (best.radius < 0 || radius < best.radius) {
            best = {center, radius};
        }
        if (step == kSteps) {
            return best;
        }
        center += (glm::dvec3(points[farthest.index]) - center) / (step + 1.0);
    }
}

} // namespace hyalite
