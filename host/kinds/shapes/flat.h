// Shared by quads and disks: the two axes that span them.
#pragma once

#include <glm/glm.hpp>

namespace hyalite::kinds {

// Transforms the axes. A mirroring map reverses their cross product, so it also swaps them: the front is then the
// mirror image of the front.
void transformAxes(const glm::dmat4& map, glm::dvec3& axis0, glm::dvec3& axis1);

[[nodiscard]] bool areParallel(const glm::dvec3& a, const glm::dvec3& b);

} // namespace hyalite::kinds
