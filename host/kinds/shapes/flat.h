// What quads and disks share: two axes that span them.
#pragma once

#include <glm/glm.hpp>

namespace hyalite::kinds {

// The images of the axes. A mirror image turns their cross product round; swapping them keeps the front where the
// mirror put it.
void transformAxes(const glm::dmat4& map, glm::dvec3& axis0, glm::dvec3& axis1);

[[nodiscard]] bool areParallel(const glm::dvec3& a, const glm::dvec3& b);

} // namespace hyalite::kinds
