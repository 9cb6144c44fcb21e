// See directional.h.
#include "reference/lights/directional.h"

#include <numbers>

namespace hyalite::reference {

using std::numbers::pi;

ParallelLight makeParallel(const DirectionalLight& light, const LightSphere& sphere) {
    ParallelLight parallel{.direction = light.direction, .irradiance = light.irradiance};
    if (light.beam) {
        parallel.center = light.beam->center;
        parallel.radius = light.beam->radius;
    } else {
        parallel.isEverywhere = true;
        parallel.center = sphere.center - sphere.distance * light.direction;
        parallel.radius = sphere.radius;
    }
    return parallel;
}

Offer offerTo(const glm::dvec3& receiver, const ParallelLight& light, glm::dvec2 /*uv*/) {
    const double along = glm::dot(receiver - light.center, light.direction);
    const double distance = light.isEverywhere ? kBeyond : along;
    const bool isLit = light.isEverywhere || (along > 0 && startDisc(light)->isPassed(receiver, light.direction));
    const glm::dvec3 way = -distance * light.direction;
    return {.toLight = way, .shadowEnd = receiver + way, .irradiance = isLit ? light.irradiance : glm::dvec3(0)};
}

double pdfToward(const ParallelLight& /*light*/, const glm::dvec3& /*direction*/, double /*distance*/,
                 const glm::dvec3& /*lightNormal*/) {
    return 0;
}

LightRay emitFrom(const ParallelLight& light, glm::dvec2 uOrigin, glm::dvec2 /*uDirection*/) {
    const StartDisc disc{light.center, light.radius};
    return {.origin = disc.point(light.direction, uOrigin), .direction = light.direction, .pdfOrigin = 1 / disc.area()};
}

double emissionDensity(const ParallelLight& /*light*/, const glm::dvec3& /*normal*/, const glm::dvec3& /*direction*/) {
    return 0;
}

double emissionCosine(const ParallelLight& /*light*/) {
    return -1;
}

std::optional<StartDisc> startDisc(const ParallelLight& light) {
    return StartDisc{light.center, light.radius};
}

glm::dvec3 fluxOf(const ParallelLight& light) {
    return pi * light.radius * light.radius * light.irradiance;
}

} // namespace hyalite::reference
