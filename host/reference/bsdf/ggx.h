// The isotropic GGX distribution of microfacets with Smith's masking [Walter07], [Heitz14]. Directions are unit, in the
// frame of the surface: z along its normal.
#pragma once

#include <glm/glm.hpp>

namespace hyalite::reference {

// D(m) [1/sr]; 0 below the surface.
[[nodiscard]] double ggxDistribution(const glm::dvec3& m, double alpha);

// Smith's Lambda of a direction on either side of the surface.
[[nodiscard]] double smithLambda(const glm::dvec3& w, double alpha);

// Fraction of the facets facing w that are visible from w.
[[nodiscard]] double smithG1(const glm::dvec3& w, double alpha);

// Density [1/sr] of the normals visible from wo, with facets weighted by their area projected towards wo: max(0, wo .
// m) D(m) G1(wo) / wo.z. wo.z > 0.
[[nodiscard]] double visibleNormalDensity(const glm::dvec3& wo, const glm::dvec3& m, double alpha);

// Samples a normal with that density [Dupuy23].
[[nodiscard]] glm::dvec3 sampleVisibleNormal(const glm::dvec3& wo, double alpha, glm::dvec2 uv);

} // namespace hyalite::reference
