// See affine.h.
#include "scene/model/affine.h"

#include "scene/model/scene_limits.h"

#include <cmath>

namespace hyalite {

bool isInvertible(const glm::dmat4& matrix) {
    const glm::dmat3 linear(matrix);
    double product = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double stretch = glm::length(linear[axis]);
        if (!(stretch >= kSmallestLength && stretch <= kLargestLength)) {
            return false;
        }
        product *= stretch;
    }
    constexpr double kFlattest = 1e-9; // volume of the unit cube's image over that of a box with the same edges
    return std::abs(glm::determinant(linear)) >= kFlattest * product;
}

} // namespace hyalite
