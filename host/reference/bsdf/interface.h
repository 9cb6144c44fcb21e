// Light at a smooth surface: mirror direction, Snell's law, Fresnel's equations. Directions point along the
// propagation; the normal is unit and on the side of the incident light.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace hyalite::reference {

// R = I - 2 (N.I) N.
[[nodiscard]] glm::dvec3 reflect(const glm::dvec3& direction, const glm::dvec3& normal);

// Snell: eta = index on the incident side over index on the other. None: total internal reflection.
[[nodiscard]] std::optional<glm::dvec3> refract(const glm::dvec3& direction, const glm::dvec3& normal, double eta);

// Fraction of unpolarised light reflected at the boundary of two dielectrics; 1 beyond the critical angle. cosIncident
// in [0, 1], eta as above.
[[nodiscard]] double fresnelDielectric(double cosIncident, double eta);

// Cosine between the ray and the normal facing it; 0 if a shading normal is turned away from the ray.
[[nodiscard]] double incidentCosine(const glm::dvec3& direction, const glm::dvec3& normal);

} // namespace hyalite::reference
