// What the surface of a material does with light: a diffuse part, a lobe that reflects and perhaps transmits, or both.
// Lobes are smooth, or rough by GGX microfacets [Walter07]. wo and wi are unit and point away from the surface, wo to
// the side that the normals are on. Rough lobes let a ray meet one facet only: what would be reflected from facet to
// facet is lost.
#pragma once

#include "reference/bsdf/bsdf_model.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite::reference {

// kBsdf…: what the surface may do with light. The absorber's are 0.
[[nodiscard]] std::uint32_t bsdfFlags(const MaterialModel& material);

// What reflects diffusely, and what lies over it lets through.
struct DiffusePart {
    MaterialModel material;
    glm::dvec3 share; // of the light reflected, but for what lies over it on the way in and out

    [[nodiscard]] double letThrough(double cosine) const;
    [[nodiscard]] double meanLetThrough() const; // of light that comes evenly from everywhere
};

// None where the material reflects nothing diffusely.
[[nodiscard]] std::optional<DiffusePart> diffusePart(const MaterialModel& material);

// What the diffuse part reflects of light from a direction of cosine cosIn to one of cosine cosOut, times pi.
[[nodiscard]] glm::dvec3 diffuseReflectance(const DiffusePart& diffuse, double cosOut, double cosIn);

// None where the material is diffuse alone. `front`: seen from the front.
[[nodiscard]] std::optional<Lobe> lobeOf(const MaterialModel& material, bool front);

// The lobe that lies over the rest of the material; none where there is none.
[[nodiscard]] std::optional<Lobe> coatOf(const MaterialModel& material);

// What lies over the lobe lets through at an angle.
[[nodiscard]] double overLobe(const Lobe& lobe, double cosine);

// The lobe that a path takes: `lobe` or the coat over it, and the probability of that. `choice` in [0, 1).
struct PickedLobe {
    Lobe lobe;
    double probability = 1;
};
[[nodiscard]] PickedLobe pickLobe(const Lobe& lobe, double cosOut, double choice);

// Share of the light that a facet reflects.
[[nodiscard]] glm::dvec3 facetReflectance(const Lobe& lobe, double cosine);

// The probability with which a path takes a lobe where it takes one of lobes and diffuse part.
[[nodiscard]] double lobeProbability(const std::optional<Lobe>& lobe, const std::optional<DiffusePart>& diffuse,
                                     double cosOut);

struct ShadingNormals {
    glm::dvec3 normal;          // unit, for shading
    glm::dvec3 geometricNormal; // unit; directions that the two see on different sides are absorbed
};

enum class Transport { Radiance, Flux }; // what crosses a boundary is scaled by the squared indices, or is not

struct BsdfSample {
    glm::dvec3 direction;
    glm::dvec3 weight;    // f times cosine over density
    double pdfW = 0;      // of the part that was taken [1/sr]; 0: smooth, there is no other direction
    bool through = false; // to the other side
};

// A direction for wi; none: absorbed. `choice` in [0, 1) decides between reflection and refraction, uv the facet.
[[nodiscard]] std::optional<BsdfSample> sampleLobe(const Lobe& lobe, const ShadingNormals& normals,
                                                   const glm::dvec3& wo, glm::dvec2 uv, double choice,
                                                   Transport transport);

struct BsdfValue {
    glm::dvec3 f{0};        // [1/sr]
    double pdfW = 0;        // with which wi is sampled for wo [1/sr]
    double reversePdfW = 0; // and wo for wi, seen from wi's side [1/sr]
};

// Of a rough lobe; 0 for directions that it never takes.
[[nodiscard]] BsdfValue evaluateLobe(const Lobe& lobe, const ShadingNormals& normals, const glm::dvec3& wo,
                                     const glm::dvec3& wi, Transport transport);

// The whole BSDF: a direction of one of its parts, its probability in weight and density, and what all of them make of
// a pair of directions. A smooth lobe has no value and no density. uv: within the part, choice: which.
[[nodiscard]] std::optional<BsdfSample> sampleBsdf(const MaterialModel& material, bool front,
                                                   const ShadingNormals& normals, const glm::dvec3& wo, glm::dvec2 uv,
                                                   double choice, Transport transport);
[[nodiscard]] BsdfValue evaluateBsdf(const MaterialModel& material, bool front, const ShadingNormals& normals,
                                     const glm::dvec3& wo, const glm::dvec3& wi, Transport transport);

} // namespace hyalite::reference
