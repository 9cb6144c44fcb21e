// Textures at a point of a surface, and the materials that they colour.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>

namespace hyalite::reference {

struct World;
struct Surface;

// The texture's value, in [0, 1], at surface coordinates uv and a point of the world [m].
[[nodiscard]] glm::dvec3 evaluateTexture(const TextureModel& texture, const glm::dvec2& uv, const glm::dvec3& position);

// The model of the surface's material, which it must have, with its textures multiplied in.
[[nodiscard]] MaterialModel texturedModel(const World& world, const Surface& surface);

} // namespace hyalite::reference
