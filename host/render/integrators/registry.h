// The integrators by name.
#pragma once

#include "render/integrators/integrator.h"

#include <span>

namespace hyalite::render {

// In the order of kIntegrators.
[[nodiscard]] std::span<const IntegratorKind> integratorKinds();

// The scene's. Throws Error(WrongUsage) where the name is unknown.
[[nodiscard]] const IntegratorKind& integratorKind(const Scene& scene);

// The scene's picture by the reference. Throws what reference::render throws.
[[nodiscard]] LayeredImage renderByReference(const Scene& scene, const reference::RenderOptions& options = {});

} // namespace hyalite::render
