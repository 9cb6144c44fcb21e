// Picks the integrator.
#include "reference/render.h"

#include "reference/bsdf/custom_twins.h"
#include "reference/integrators/path.h"
#include "reference/integrators/photon_views.h"
#include "reference/integrators/ppm.h"
#include "reference/integrators/whitted.h"

#include <algorithm>

namespace hyalite::reference {

LayeredImage render(const Scene& scene, const RenderOptions& options) {
    if (const CustomCode* code = codeWithoutTwin(scene)) {
        throw Error(ExitCode::WrongUsage, SourceLocation{.file = code->file},
                    "this code of the scene is GLSL alone: the reference has no twin of it",
                    "render with --backend vulkan");
    }
    const World world = prepareWorld(scene);
    if (std::none_of(world.lights.begin(), world.lights.end(), [](const Light& light) { return light.pmf > 0; })) {
        throw Error(ExitCode::BadInput, SourceLocation{.file = scene.file}, "the scene emits no light",
                    "add a light, or an emission to a quad");
    }
    switch (scene.render.integrator) {
    case Integrator::Whitted:
        return renderWhitted(world, options);
    case Integrator::PhotonMap:
        return renderPhotonMap(world, options);
    case Integrator::Path:
        return renderPath(world, options);
    case Integrator::Ppm:
        break;
    }
    return renderPpm(world, options);
}

} // namespace hyalite::reference
