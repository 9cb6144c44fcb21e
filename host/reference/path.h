// Unidirectional path tracing with next-event estimation [Kajiya86]: slow on caustics, but free of bias.
#pragma once

#include "image/image.h"
#include "reference/render.h"
#include "reference/world.h"

#include <cstdint>

namespace hyalite::reference {

// Radiance [W/(m^2 sr)] of one path, `pass`, of a pixel; render.maxDepth counts the segments from the light to the eye.
[[nodiscard]] glm::dvec3 pathRadiance(const World& world, std::uint32_t pixel, std::uint32_t pass);

[[nodiscard]] LayeredImage renderPath(const World& world, const RenderOptions& options);

} // namespace hyalite::reference
