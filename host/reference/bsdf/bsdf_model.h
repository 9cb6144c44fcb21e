// Interface of a BSDF model: one row per model of shaders/shared/materials.h, in a file named after it. Textures are
// already multiplied into the materials; cosines are taken to the normal, or to a facet's normal.
#pragma once

#include "scene/model/material_model.h"

#include <glm/glm.hpp>

namespace hyalite::reference {

// Reflection or refraction, smooth or at microfacets, seen from one side.
struct Lobe {
    MaterialModel material;
    double eta = 1;   // transmitting lobe: index on this side over index on the other
    double alpha = 0; // of the GGX distribution; 0: smooth
    bool transmits = false;
    bool isCoat = false; // over the material's other lobe
};

struct BsdfModel {
    std::uint32_t (*flags)(const MaterialModel& material) = nullptr; // kBsdf…

    // For a model with a diffuse part, else nullptr: its albedo without the layer above it, the transmission of that
    // layer at an angle, and the mean transmission over the cosine-weighted hemisphere.
    glm::dvec3 (*albedo)(const MaterialModel& material) = nullptr;
    double (*overDiffuse)(const MaterialModel& material, double cosine) = nullptr;
    double (*meanOverDiffuse)(const MaterialModel& material) = nullptr;

    // For a model with a lobe, else nullptr: the lobe, and the reflectance of its facets.
    Lobe (*lobe)(const MaterialModel& material, bool front) = nullptr;
    glm::dvec3 (*reflectance)(const Lobe& lobe, double cosine) = nullptr;

    // For a model with a coat over the rest, else nullptr: the coat, and its transmission to the lobe at an angle.
    Lobe (*coat)(const MaterialModel& material) = nullptr;
    double (*overLobe)(const MaterialModel& material, double cosine) = nullptr;
};

#define ROW(Name, name) extern const BsdfModel k##Name##Bsdf;
HYALITE_MODELS(ROW)
#undef ROW

// Alpha of the GGX distribution for this roughness; 0: smooth.
[[nodiscard]] double facetAlpha(double roughness);

// kBsdfGlossy or kBsdfSpecular, by the roughness.
[[nodiscard]] std::uint32_t lobeFlag(double roughness);

} // namespace hyalite::reference
