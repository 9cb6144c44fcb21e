// Bounding spheres of point sets: the targets of photons that are aimed at a mesh.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace hyalite {

struct BoundingSphere {
    glm::dvec3 center{0};
    double radius = -1; // negative: of no points
};

// A sphere that holds all points: Ritter's [Ritter90], its centre then improved by steps towards the farthest point
// [Badoiu03]. The radius is at most 20 % above the least possible; on 807 sets of the tests 2 % at worst. Linear in
// time, on all cores; the same for any number of them. Points are finite.
[[nodiscard]] BoundingSphere boundingSphere(std::span<const glm::vec3> points);

} // namespace hyalite
