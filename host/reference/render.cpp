// Picks the integrator.
#include "reference/render.h"

#include "reference/ppm.h"
#include "reference/whitted.h"

#include <algorithm>

namespace hyalite::reference {

LayeredImage render(const Scene& scene, const RenderOptions& options) {
    const World world = prepareWorld(scene);
    if (std::none_of(world.lights.begin(), world.lights.end(), [](const Light& light) { return light.pmf > 0; })) {
        throw Error(ExitCode::BadInput, SourceLocation{.file = scene.file}, "the scene emits no light",
                    "add a light, or an emission to a quad");
    }
    switch (scene.render.integrator) {
    case Integrator::Whitted:
        return {.picture = renderWhitted(world, options), .layers = {}};
    case Integrator::Ppm:
        return {.picture = renderPpm(world, options), .layers = {}};
    }
    throw Error(ExitCode::WrongUsage, "unknown integrator");
}

} // namespace hyalite::reference
