// The targets of caustic photons: spheres around everything that reflects or refracts like a mirror.
#pragma once

#include "geometry/bounding_sphere.h"
#include "scene/model/scene.h"

#include <vector>

namespace hyalite {

// Most spheres: every photon tests all of them.
inline constexpr std::size_t kMostTargets = 64;

// World space [m]; the radius is infinite where a specular object has no end. Objects beyond kMostTargets are taken
// together with their neighbours. Empty: the scene holds nothing specular. Deterministic.
[[nodiscard]] std::vector<BoundingSphere> specularTargets(const Scene& scene);

} // namespace hyalite
