// Fresnel's equations for conductors, and Schlick's approximation. For dielectrics: interface.h.
#pragma once

#include <glm/glm.hpp>

namespace hyalite::reference {

// Fraction of unpolarised light reflected at the boundary from a dielectric to a metal with the relative index eta + i
// k; cosIncident in [0, 1].
[[nodiscard]] double fresnelConductor(double cosIncident, double eta, double k);

// 1 - (1 - cos)^5: with reflectance F0 at normal incidence, Schlick's approximation transmits (1 - F0) times this.
[[nodiscard]] double coatTransmission(double cosine);

} // namespace hyalite::reference
