// The picture that photon mapping renders, and the views of its maps that render.view can select instead.
#pragma once

#include "image/layered_image.h"
#include "reference/render.h"
#include "reference/world.h"

namespace hyalite::reference {

// Renders the view selected by render.view.
[[nodiscard]] LayeredImage renderPhotonMap(const World& world, const RenderOptions& options);

} // namespace hyalite::reference
