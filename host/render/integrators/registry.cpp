#include "render/integrators/registry.h"

#include "render/integrators/path/path.h"
#include "render/integrators/photonmap/photon_mapping.h"
#include "render/integrators/ppm/ppm.h"
#include "render/integrators/whitted/whitted.h"
#include "scene/model/integrators.h"

#include <algorithm>
#include <array>

namespace hyalite::render {

std::span<const IntegratorKind> integratorKinds() {
    // One line per integrator; everything else about an integrator is in its folder
    static const std::array<IntegratorKind, kIntegrators.size()> all{
        Ppm::kind(),
        PhotonMapping::kind(),
        Whitted::kind(),
        PathTracing::kind(),
    };
    return all;
}

const IntegratorKind& integratorKind(const Scene& scene) {
    return *std::ranges::find(integratorKinds(), integratorNamed(scene.render.integrator).name, &IntegratorKind::name);
}

LayeredImage renderByReference(const Scene& scene, const reference::RenderOptions& options) {
    return reference::render(scene, integratorKind(scene).reference, options);
}

} // namespace hyalite::render
