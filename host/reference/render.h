// The double-precision reference: renders a scene on the CPU, recursively, in textbook form. It shares only random
// integers with the kernels; with the same seed both should render the same picture.
#pragma once

#include "image/error_estimate.h"
#include "image/layered_image.h"
#include "scene/model/scene.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace hyalite::reference {

struct World;

struct RenderOptions {
    // Called after each pass with the number of passes done and the estimated error, see docs/metrics.md; false ends
    // the rendering. Empty: renders all passes.
    std::function<bool(std::uint32_t passesDone, const ErrorEstimate& error)> afterPass;
};

// Renders a world with its settings: one function per integrator, see render/integrators/registry.h. Returns the mean
// of the passes, bit-identical for any number of threads.
using Integrator = LayeredImage (*)(const World& world, const RenderOptions& options);

// Renders the scene with that integrator. Throws Error(BadInput) if the scene cannot be rendered or emits no light.
[[nodiscard]] LayeredImage render(const Scene& scene, Integrator integrator, const RenderOptions& options = {});

} // namespace hyalite::reference
