// The picture that photon mapping makes, and the looks into its maps that it offers instead.
#pragma once

#include "image/layered_image.h"
#include "reference/render.h"
#include "reference/world.h"

namespace hyalite::reference {

// What render.view asks for.
[[nodiscard]] LayeredImage renderPhotonMap(const World& world, const RenderOptions& options);

} // namespace hyalite::reference
