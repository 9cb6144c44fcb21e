#include "reference/lights/point.h"

#include <numbers>

namespace hyalite::reference {

using std::numbers::pi;

Offer offerTo(const glm::dvec3& receiver, const PointLight& light, glm::dvec2 /*uv*/) {
    return offerFrom(light.position, receiver, light.intensity);
}

double pdfToward(const PointLight& /*light*/, const glm::dvec3& /*direction*/, double /*distance*/,
                 const glm::dvec3& /*lightNormal*/) {
    return 0;
}

LightRay emitFrom(const PointLight& light, glm::dvec2 /*uOrigin*/, glm::dvec2 uDirection) {
    return {.origin = light.position, .direction = uniformSphere(uDirection), .pdfDirection = 1 / (4 * pi)};
}

double emissionDensity(const PointLight& /*light*/, const glm::dvec3& /*normal*/, const glm::dvec3& /*direction*/) {
    return 1 / (4 * pi);
}

double emissionCosine(const PointLight& /*light*/) {
    return -1;
}

std::optional<StartDisc> startDisc(const PointLight& /*light*/) {
    return std::nullopt;
}

glm::dvec3 fluxOf(const PointLight& light) {
    return 4 * pi * light.intensity;
}

} // namespace hyalite::reference
