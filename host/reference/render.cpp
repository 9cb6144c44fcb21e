#include "reference/render.h"

#include "reference/bsdf/custom_twins.h"
#include "reference/integrators/learn_lights.h"
#include "reference/world.h"

#include <algorithm>

namespace hyalite::reference {

LayeredImage render(const Scene& scene, Integrator integrator, const RenderOptions& options) {
    if (const CustomCode* code = codeWithoutTwin(scene)) {
        throw noTwin(*code);
    }
    World world = prepareWorld(scene);
    if (std::none_of(world.lights.begin(), world.lights.end(), [](const Light& light) { return light.pmf > 0; })) {
        throw Error(ExitCode::BadInput, SourceLocation{.file = scene.file}, "the scene emits no light",
                    "add a light, or an emission to a quad");
    }
    learnLights(world, photonShares(scene));
    return integrator(world, options);
}

} // namespace hyalite::reference
