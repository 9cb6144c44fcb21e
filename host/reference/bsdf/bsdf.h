// BSDF of a material: a diffuse part, a lobe that reflects and may also transmit, or both. Lobes are smooth, or rough
// with GGX microfacets [Walter07]. wo and wi are unit and point away from the surface; wo is on the side of the
// normals. Rough lobes are single-scattering: light reflected between facets is lost.
#pragma once

#include "reference/bsdf/bsdf_model.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite::reference {

// kBsdf… flags of the material; 0 for one that only absorbs.
[[nodiscard]] std::uint32_t bsdfFlags(const MaterialModel& material);

// The diffuse part, and the transmission of the layer above it.
struct DiffusePart {
    MaterialModel material;
    glm::dvec3 share; // albedo, without the layer's transmission on entry and exit

    [[nodiscard]] double letThrough(double cosine) const;
    [[nodiscard]] double meanLetThrough() const; // under uniform illumination
};

// None if the material has no diffuse reflection.
[[nodiscard]] std::optional<DiffusePart> diffusePart(const MaterialModel& material);

// pi times the BSDF of the diffuse part, from a direction with cosine cosIn to one with cosine cosOut.
[[nodiscard]] glm::dvec3 diffuseReflectance(const DiffusePart& diffuse, double cosOut, double cosIn);

// None if the material is purely diffuse. `front`: seen from the front.
[[nodiscard]] std::optional<Lobe> lobeOf(const MaterialModel& material, bool front);

// The coat over the rest of the material; none if the material has no coat.
[[nodiscard]] std::optional<Lobe> coatOf(const MaterialModel& material);

// Transmission of the layer over the lobe, at the angle with this cosine.
[[nodiscard]] double overLobe(const Lobe& lobe, double cosine);

// The lobe that a path takes: `lobe` or the coat over it, with its selection probability. `choice` in [0, 1).
struct PickedLobe {
    Lobe lobe;
    double probability = 1;
};
[[nodiscard]] PickedLobe pickLobe(const Lobe& lobe, double cosOut, double choice);

// Share of the light that a facet reflects.
[[nodiscard]] glm::dvec3 facetReflectance(const Lobe& lobe, double cosine);

// Probability that a path takes a lobe rather than the diffuse part.
[[nodiscard]] double lobeProbability(const std::optional<Lobe>& lobe, const std::optional<DiffusePart>& diffuse,
                                     double cosOut);

struct ShadingNormals {
    glm::dvec3 normal;          // unit, for shading
    glm::dvec3 geometricNormal; // unit; a direction on different sides of the two normals is absorbed
};

enum class Transport { Radiance, Flux }; // a boundary scales radiance by the squared index ratio, flux not

struct BsdfSample {
    glm::dvec3 direction;
    glm::dvec3 weight;    // f times cosine over density
    double pdfW = 0;      // of the chosen part [1/sr]; 0: smooth, a delta direction
    bool through = false; // to the other side
};

// Samples wi; none: absorbed. `choice` in [0, 1) decides between reflection and refraction, uv the facet.
[[nodiscard]] std::optional<BsdfSample> sampleLobe(const Lobe& lobe, const ShadingNormals& normals,
                                                   const glm::dvec3& wo, glm::dvec2 uv, double choice,
                                                   Transport transport);

struct BsdfValue {
    glm::dvec3 f{0};        // [1/sr]
    double pdfW = 0;        // density of sampling wi given wo [1/sr]
    double reversePdfW = 0; // density of sampling wo given wi, from wi's side [1/sr]
};

// Evaluates a rough lobe; 0 for directions that it never samples.
[[nodiscard]] BsdfValue evaluateLobe(const Lobe& lobe, const ShadingNormals& normals, const glm::dvec3& wo,
                                     const glm::dvec3& wi, Transport transport);

// The whole BSDF. Sampling picks one part and includes its selection probability in weight and density; evaluation sums
// all parts. A smooth lobe has zero value and density. `choice` selects the part, `uv` the direction within it.
[[nodiscard]] std::optional<BsdfSample> sampleBsdf(const MaterialModel& material, bool front,
                                                   const ShadingNormals& normals, const glm::dvec3& wo, glm::dvec2 uv,
                                                   double choice, Transport transport);
[[nodiscard]] BsdfValue evaluateBsdf(const MaterialModel& material, bool front, const ShadingNormals& normals,
                                     const glm::dvec3& wo, const glm::dvec3& wi, Transport transport);

} // namespace hyalite::reference
