// The laws of reflection and refraction.
#include "reference/bsdf/materials.h"

#include <algorithm>
#include <cmath>
#include <complex>

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
    // The tangential part shrinks by eta (Snell), the normal part makes the result unit again.
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

double fresnelConductor(double cosIncident, double eta, double k) {
    // The dielectric's amplitudes with a complex index and so a complex cosine
    const std::complex<double> n2 = std::pow(std::complex<double>(eta, k), 2);
    const std::complex<double> nCosTransmitted = std::sqrt(n2 - (1 - cosIncident * cosIncident));
    const std::complex<double> perpendicular = (cosIncident - nCosTransmitted) / (cosIncident + nCosTransmitted);
    const std::complex<double> parallel = (n2 * cosIncident - nCosTransmitted) / (n2 * cosIncident + nCosTransmitted);
    return (std::norm(perpendicular) + std::norm(parallel)) / 2;
}

double coatTransmission(double cosine) {
    return 1 - std::pow(std::clamp(1 - cosine, 0.0, 1.0), 5);
}

} // namespace hyalite::reference
