// What a BSDF model says of itself: one row per model of shaders/shared/materials.h, in a file of its name. The
// materials have their textures multiplied in; cosines are those to the normal, or to a facet's.
#pragma once

#include "scene/model/material_model.h"

#include <glm/glm.hpp>

namespace hyalite::reference {

// Reflection or refraction, smooth or at microfacets, seen from one side.
struct Lobe {
    MaterialModel material;
    double eta = 1;   // of a lobe that transmits: index of this side over that of the other
    double alpha = 0; // of the GGX distribution; 0: smooth
    bool transmits = false;
    bool isCoat = false; // over the material's other lobe
};

struct BsdfModel {
    std::uint32_t (*flags)(const MaterialModel& material) = nullptr; // kBsdf…

    // Of a model with a diffuse part, else nullptr: the share of the light reflected, but for what lies over it; what
    // that lets through at an angle, and the mean of this over the cosine-weighted hemisphere.
    glm::dvec3 (*albedo)(const MaterialModel& material) = nullptr;
    double (*overDiffuse)(const MaterialModel& material, double cosine) = nullptr;
    double (*meanOverDiffuse)(const MaterialModel& material) = nullptr;

    // Of a model with a lobe, else nullptr: the lobe, and the share of the light that a facet of it reflects.
    Lobe (*lobe)(const MaterialModel& material, bool front) = nullptr;
    glm::dvec3 (*reflectance)(const Lobe& lobe, double cosine) = nullptr;

    // Of a model with a second lobe over all else, else nullptr: that coat, and what it lets through to the lobe at an
    // angle.
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
