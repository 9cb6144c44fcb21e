#include "reference/bsdf/fresnel.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace hyalite::reference {

double fresnelConductor(double cosIncident, double eta, double k) {
    // The dielectric's amplitudes, with a complex index and therefore a complex cosine
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
