// Unidirectional path tracing with next-event estimation [Kajiya86]: slow on caustics, but unbiased.
#pragma once

#include "image/image.h"
#include "reference/integrators/shading.h"
#include "reference/render.h"
#include "reference/world.h"

#include <cstdint>
#include <optional>

namespace hyalite::reference {

// Radiance [W/(m^2 sr)] of one path, `pass`, of a pixel; render.maxDepth counts the segments from the light to the eye.
[[nodiscard]] glm::dvec3 pathRadiance(const World& world, std::uint32_t pixel, std::uint32_t pass);

// The next ray of `path` from the diffuse surface that it has reached. None: the path ends. `shift`: see
// sampleUnitSquare.
[[nodiscard]] std::optional<NextRay> bouncePath(const World& world, const VisiblePoint& x, const CameraPath& path,
                                                std::uint32_t pass, double shift = 0);

[[nodiscard]] LayeredImage renderPath(const World& world, const RenderOptions& options);

} // namespace hyalite::reference
