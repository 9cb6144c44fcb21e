// The integrators by name.
#pragma once

#include "render/integrators/integrator.h"

#include <span>

namespace hyalite::render {

// In the order of kIntegrators.
[[nodiscard]] std::span<const IntegratorKind> integratorKinds();

// The scene's integrator. Throws Error(WrongUsage) if the name is unknown.
[[nodiscard]] const IntegratorKind& integratorKind(const Scene& scene);

// Renders the scene with the double-precision reference. Throws what reference::render throws.
[[nodiscard]] LayeredImage renderByReference(const Scene& scene, const reference::RenderOptions& options = {});

} // namespace hyalite::render
