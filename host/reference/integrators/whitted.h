// Recursive ray tracing: mirror reflections, refractions and shadows, no diffuse interreflection [Whitted80].
#pragma once

#include "image/image.h"
#include "reference/render.h"
#include "reference/world.h"

#include <cstdint>

namespace hyalite::reference {

// Radiance [W/(m^2 sr)] of one sample, `pass`, of a pixel.
[[nodiscard]] glm::dvec3 whittedRadiance(const World& world, std::uint32_t pixel, std::uint32_t pass);

[[nodiscard]] LayeredImage renderWhitted(const World& world, const RenderOptions& options);

} // namespace hyalite::reference
