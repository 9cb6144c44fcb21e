// Fresnel's equations for conductors, and Schlick's approximation. For dielectrics: interface.h.
#pragma once

#include <glm/glm.hpp>

namespace hyalite::reference {

// Fraction of unpolarised light that the boundary from a dielectric to a metal of the index eta + i k relative to it
// reflects; cosIncident in [0, 1].
[[nodiscard]] double fresnelConductor(double cosIncident, double eta, double k);

// 1 - (1 - cos)^5: with F0 at normal incidence Schlick's approximation lets (1 - F0) times this through.
[[nodiscard]] double coatTransmission(double cosine);

} // namespace hyalite::reference
