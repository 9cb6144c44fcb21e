// The laws of reflection and refraction.
#include "reference/bsdf/interface.h"

#include <algorithm>
#include <cmath>

namespace hyalite::reference {

glm::dvec3 reflect(const glm::dvec3& direction, const glm::dvec3& normal) {
    return direction - 2 * glm::dot(normal, direction) * normal;
}

double incidentCosine(const glm::dvec3& direction, const glm::dvec3& normal) {
    return std::clamp(-glm::dot(direction, normal), 0.0, 1.0);
}

std::optional<glm::dvec3> refract(const glm::dvec3& direction, const glm::dvec3& normal, double eta) {
    const double cosIncident = incidentCosine(direction, normal);
    const double sin2Transmitted = eta * eta * (1 - cosIncident * cosIncident);
    if (sin2Transmitted >= 1) {
        return std::nullopt;
    }
    // The tangential part is scaled by eta (Snell); the normal part makes the result unit length.
    const double cosTransmitted = std::sqrt(1 - sin2Transmitted);
    return glm::normalize(eta * direction + (eta * cosIncident - cosTransmitted) * normal);
}

double fresnelDielectric(double cosIncident, double eta) {
    const double sin2Transmitted = eta * eta * (1 - cosIncident * cosIncident);
    if (sin2Transmitted >= 1) {
        return 1;
    }
    const double cosTransmitted = std::sqrt(1 - sin2Transmitted);
    const double perpendicular = (eta * cosIncident - cosTransmitted) / (eta * cosIncident + cosTransmitted);
    const double parallel = (cosIncident - eta * cosTransmitted) / (cosIncident + eta * cosTransmitted);
    return (perpendicular * perpendicular + parallel * parallel) / 2;
}

} // namespace hyalite::reference
