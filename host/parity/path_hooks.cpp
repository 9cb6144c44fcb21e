#include "parity/path_hooks.h"

namespace hyalite::parity {

PathHooks hooksOf(Integrator integrator) {
    switch (integrator) {
    case Integrator::Whitted:
        return {};
    case Integrator::Ppm: // no path depends on radii: none need be found
        return {.simplify = [](RenderSettings& render) {
            render.radius = 1;
            render.photonMap.causticRadius = 1;
        }};
    case Integrator::PhotonMap: // views of the maps show no camera path
        return {.photonsAreTracedOnce = true,
                .simplify = [](RenderSettings& render) { render.photonMap.view = PhotonView::Picture; }};
    case Integrator::Path:
        return {.bouncesAtDiffuse = true};
    }
    return {};
}

} // namespace hyalite::parity
