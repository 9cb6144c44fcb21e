// What the surface of a material does with light: a diffuse part, a lobe that reflects and perhaps transmits, or both.
// Lobes are smooth, or rough by GGX microfacets [Walter07]. wo and wi are unit and point away from the surface, wo to
// the side that the normals are on. Rough lobes let a ray meet one facet only: what would be reflected from facet to
// facet is lost.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite::reference {

struct DiffusePart {
    glm::dvec3 share;    // of the light reflected, but for the coat's factors on the way in and out
    bool coated = false; // see coatTransmission
};

// None where the material reflects nothing diffusely.
[[nodiscard]] std::optional<DiffusePart> diffusePart(const MaterialModel& model);

// What the diffuse part reflects of light from a direction of cosine cosIn to one of cosine cosOut, times pi.
[[nodiscard]] glm::dvec3 diffuseReflectance(const DiffusePart& diffuse, double cosOut, double cosIn);

// A lobe seen from one side.
struct Lobe {
    MaterialModel model; // any but diffuse
    double eta = 1;      // dielectric: index of this side over that of the other
    double alpha = 0;    // of the GGX distribution; 0: smooth
};

// None where the material is diffuse alone. `front`: seen from the front.
[[nodiscard]] std::optional<Lobe> lobeOf(const MaterialModel& model, bool front);

// Share of the light that a facet reflects.
[[nodiscard]] glm::dvec3 facetReflectance(const Lobe& lobe, double cosine);

// The probability with which a path takes the lobe where it takes one of the two.
[[nodiscard]] double lobeProbability(const std::optional<Lobe>& lobe, const std::optional<DiffusePart>& diffuse,
                                     double cosOut);

struct ShadingNormals {
    glm::dvec3 normal;          // unit, for shading
    glm::dvec3 geometricNormal; // unit; directions that the two see on different sides are absorbed
};

enum class Transport { Radiance, Flux }; // what crosses a boundary is scaled by the squared indices, or is not

struct LobeSample {
    glm::dvec3 direction;
    glm::dvec3 weight;    // f times cosine over density
    double pdfW = 0;      // [1/sr]; 0: smooth, there is no other direction
    bool through = false; // to the other side
};

// A direction for wi; none: absorbed. `choice` in [0, 1) decides between reflection and refraction, uv the facet.
[[nodiscard]] std::optional<LobeSample> sampleLobe(const Lobe& lobe, const ShadingNormals& normals,
                                                   const glm::dvec3& wo, glm::dvec2 uv, double choice,
                                                   Transport transport);

struct LobeValue {
    glm::dvec3 f{0}; // [1/sr]
    double pdfW = 0; // with which sampleLobe takes wi [1/sr]
};

// Of a rough lobe; 0 for directions that it never takes.
[[nodiscard]] LobeValue evaluateLobe(const Lobe& lobe, const ShadingNormals& normals, const glm::dvec3& wo,
                                     const glm::dvec3& wi, Transport transport);

} // namespace hyalite::reference
