// The oracle: renders a scene on the CPU in double precision, recursively, as the textbooks write it. It shares only
// random integers with the kernels; the same seed asks both for the same picture.
#pragma once

#include "image/layered_image.h"
#include "scene/model/scene.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace hyalite::reference {

struct World;

struct RenderOptions {
    // Called after each pass with the number of passes done and the estimated error, see docs/metrics.md; false ends
    // the rendering there. Empty: all passes.
    std::function<bool(std::uint32_t passesDone, std::optional<double> error)> afterPass;
};

// Renders a world by its settings: one function for each integrator, see render/integrators/registry.h. The mean of the
// passes; the same bits for any number of threads.
using Integrator = LayeredImage (*)(const World& world, const RenderOptions& options);

// The scene by that integrator. Throws Error(BadInput) where the scene cannot be rendered or emits no light.
[[nodiscard]] LayeredImage render(const Scene& scene, Integrator integrator, const RenderOptions& options = {});

} // namespace hyalite::reference
