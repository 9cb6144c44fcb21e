#include "reference/lights/receiver.h"

#include "reference/bsdf/interface.h"

#include <numbers>

namespace hyalite::reference {

Receiver receiverAt(const VisiblePoint& x) {
    if (!x.material) {
        return {.f = glm::dvec3(1), .diffuse = {}};
    }
    const std::optional<DiffusePart> diffuse = diffusePart(*x.material);
    if (!diffuse) {
        return {.f = glm::dvec3(0), .diffuse = {}};
    }
    const double cosOut = incidentCosine(-x.wo, x.normal);
    const glm::dvec3 f = diffuse->share * diffuse->letThrough(cosOut) / std::numbers::pi;
    return {.f = x.beta * f, .diffuse = diffuse};
}

} // namespace hyalite::reference
