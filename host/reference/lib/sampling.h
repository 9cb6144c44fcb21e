// Turns the shared random integers into points and directions: the mappings from the unit square that the renderers
// sample with [Shirley97, Duff17].
#pragma once

#include "scene/model/scene.h"
#include "shaders/shared/random.h"

#include <cstdint>
#include <glm/glm.hpp>

namespace hyalite::reference {

// Maps 32 random bits to [0, 1): their upper 24 bits, which single precision also represents exactly.
[[nodiscard]] double toUnit(std::uint32_t bits);

// The sampler's pair of numbers in [0, 1)^2 for a dimension. `shift` is added to both but keeps them in that range;
// parity uses it to ask what a rounding of the numbers would change.
[[nodiscard]] glm::dvec2 sampleUnitSquare(const shared::Sampler& sampler, std::uint32_t dimension, double shift = 0);

// Concentric mapping to the unit disc, uniform in area [Shirley97].
[[nodiscard]] glm::dvec2 concentricDisc(glm::dvec2 uv);

struct Basis { // right-handed, orthonormal, with the normal as third axis
    glm::dvec3 tangent;
    glm::dvec3 bitangent;
};
[[nodiscard]] Basis orthonormalBasis(const glm::dvec3& normal); // unit normal [Duff17]

// Direction about the unit normal with pdfW = cos / pi: the disc lifted to the hemisphere (Malley's method).
[[nodiscard]] glm::dvec3 cosineHemisphere(glm::dvec2 uv, const glm::dvec3& normal);

// Direction with pdfW = 1 / (4 pi).
[[nodiscard]] glm::dvec3 uniformSphere(glm::dvec2 uv);

// Point with pdfA = 1 / area.
[[nodiscard]] glm::dvec3 pointOnQuad(glm::dvec2 uv, const Quad& quad);

} // namespace hyalite::reference
