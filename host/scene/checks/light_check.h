// Lights whose light reaches nothing that the camera sees, and caustics that an integrator leaves out. Both are found
// with paths of the reference's rays, the same in every run; a warning says how many were tried.
#pragma once

#include "scene/model/scene.h"

#include <vector>

namespace hyalite::checks {

inline constexpr int kPathsFromLight = 1024;
inline constexpr int kPathsInAll = 16384;             // lights beyond these are not tried
inline constexpr std::size_t kLargestProbed = 500000; // objects and triangles of a scene that is tried

// The warnings about the scene with its settings (integrator, camera), without those that it accepts. None for scenes
// beyond kLargestProbed.
[[nodiscard]] std::vector<Warning> lightWarnings(const Scene& scene);

} // namespace hyalite::checks
