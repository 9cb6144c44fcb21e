// Evaluates textures at a surface point, and applies them to materials.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>

namespace hyalite::reference {

struct World;
struct Surface;

// The texture's value, in [0, 1], at surface coordinates uv and a world position [m].
[[nodiscard]] glm::dvec3 evaluateTexture(const TextureModel& texture, const glm::dvec2& uv, const glm::dvec3& position);

// The model of the surface's material, with its textures multiplied in. The surface must have a material.
[[nodiscard]] MaterialModel texturedModel(const World& world, const Surface& surface);

} // namespace hyalite::reference
