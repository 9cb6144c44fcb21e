// What the dielectrics of a scene ask of a renderer: kernels leave out what no object needs.
#pragma once

#include "scene/model/scene.h"

#include <cstddef>
#include <cstdint>

namespace hyalite {

// True if some surface of the object bounds a medium: it is a dielectric, and not thin.
[[nodiscard]] bool isDielectric(const Scene& scene, const Object& object);

// Bits kMedia… of shaders/shared/media.h. What depends on where objects are is decided by their boxes: a bit may be set
// for nothing, but is never missing.
[[nodiscard]] std::uint32_t mediaNeeds(const Scene& scene);

// The number of media around a path that its list holds.
[[nodiscard]] std::size_t mediaCapacity(const Scene& scene);

} // namespace hyalite
