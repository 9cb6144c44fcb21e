// See read_placement.h.
#include "scene/yaml/read_placement.h"

#include "base/spelling.h"
#include "scene/model/quadric.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace hyalite {

glm::dvec3 transformPoint(const glm::dmat4& map, const glm::dvec3& point) {
    return map * glm::dvec4(point, 1);
}

glm::dmat3 rotationFromY(const glm::dvec3& axis) {
    const glm::dvec3 n = glm::normalize(axis);
    const double sine2 = n.x * n.x + n.z * n.z;
    if (sine2 == 0) {
        return n.y > 0 ? glm::dmat3(1) : glm::dmat3(1, 0, 0, 0, -1, 0, 0, 0, -1);
    }
    // Rodrigues' formula about y x n; this form of 1 / (1 + cos) avoids cancellation near -y.
    const double factor = n.y > 0 ? 1 / (1 + n.y) : (1 - n.y) / sine2;
    return {
        {1 - factor * n.x * n.x, -n.x, -factor * n.x * n.z}, n, {-factor * n.x * n.z, -n.z, 1 - factor * n.z * n.z}};
}

glm::dvec3 readUnit(const Value& value) {
    glm::dvec3 direction(0);
    value.read(direction, kDirection);
    const double length = glm::length(direction);
    if (!(length >= kSmallestLength)) {
        value.fail(inQuotes(value.name()) + " must not be zero", "only its direction matters, not its length");
    }
    return direction / length;
}

glm::dvec3 readAxis(Reader& reader) {
    const auto axis = reader.find("axis");
    return axis ? readUnit(*axis) : glm::dvec3(0, 1, 0);
}

glm::dmat4 placed(const Placement& placement, const glm::dvec3& center, const glm::dvec3& axis) {
    return placement.objectToWorld * glm::translate(glm::dmat4(1), center) * glm::dmat4(rotationFromY(axis));
}

bool isWithinReach(const Bounds& world) {
    const auto isTooFar = [](double side) {
        return std::isnan(side) || (std::isfinite(side) && !kCoordinate.contains(side));
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (isTooFar(world.low[axis]) || isTooFar(world.high[axis])) {
            return false;
        }
    }
    return true;
}

void checkReach(const Reader& reader, const Bounds& world) {
    if (!isWithinReach(world)) {
        throw Error(ExitCode::BadInput, reader.where(),
                    "after its transform this shape extends beyond " + numberText(kLargestLength) + " m",
                    "scenes are in metres");
    }
}

void checkThickness(const Placement& placement, double thinnest) {
    if (!placement.transform) {
        return;
    }
    const glm::dmat3 linear(placement.objectToWorld);
    const glm::dvec3 squared =
        eigensystem(glm::transpose(linear) * linear).values; // squared stretch along its principal axes
    const double least = std::sqrt(std::max(0.0, std::min({squared.x, squared.y, squared.z})));
    constexpr double kRounding = 1e-6; // relative rounding error of a product of transforms
    if (!(thinnest * least >= kSmallestLength * (1 - kRounding))) {
        placement.transform->fail("after this transform the shape is only " + numberText(thinnest * least) + " m thick",
                                  "the minimum is " + numberText(kSmallestLength) + " m");
    }
}

} // namespace hyalite
