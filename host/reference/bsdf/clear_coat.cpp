// A clear coat over metallic-roughness, after glTF's KHR_materials_clearcoat: a colourless dielectric film that covers
// the fraction `coat` of the surface. It reflects coat F of the light, by Fresnel's equations, and transmits the rest
// on entry and exit: f = f_coat + T(cosOut) T(cosIn) f_base with T = 1 - coat F.
#include "reference/bsdf/bsdf_model.h"
#include "reference/bsdf/interface.h"

#include <algorithm>
#include <cmath>

namespace hyalite::reference {

namespace {

double reflectedByCoat(const MaterialModel& material, double cosine) {
    return material.coat * fresnelDielectric(std::clamp(cosine, 0.0, 1.0), 1 / material.coatIor);
}

std::uint32_t flags(const MaterialModel& material) {
    return kMetallicRoughnessBsdf.flags(material) | lobeFlag(material.coatRoughness);
}

glm::dvec3 albedo(const MaterialModel& material) {
    return kMetallicRoughnessBsdf.albedo(material);
}

double overLobe(const MaterialModel& material, double cosine) {
    return 1 - reflectedByCoat(material, cosine);
}

double overDiffuse(const MaterialModel& material, double cosine) {
    return overLobe(material, cosine) * kMetallicRoughnessBsdf.overDiffuse(material, cosine);
}

// Mean over the squared cosine by the midpoint rule, as in the kernels: 2 c dc = d(c^2).
double meanOverDiffuse(const MaterialModel& material) {
    constexpr int kParts = 32;
    double sum = 0;
    for (int i = 0; i < kParts; ++i) {
        sum += overDiffuse(material, std::sqrt((i + 0.5) / kParts));
    }
    return sum / kParts;
}

Lobe lobe(const MaterialModel& material, bool front) {
    return kMetallicRoughnessBsdf.lobe(material, front);
}

glm::dvec3 reflectance(const Lobe& lobe, double cosine) {
    return lobe.isCoat ? glm::dvec3(reflectedByCoat(lobe.material, cosine))
                       : kMetallicRoughnessBsdf.reflectance(lobe, cosine);
}

Lobe coat(const MaterialModel& material) {
    return {.material = material, .alpha = facetAlpha(material.coatRoughness), .isCoat = true};
}

} // namespace

const BsdfModel kClearCoatBsdf{
    .flags = flags,
    .albedo = albedo,
    .overDiffuse = overDiffuse,
    .meanOverDiffuse = meanOverDiffuse,
    .lobe = lobe,
    .reflectance = reflectance,
    .coat = coat,
    .overLobe = overLobe,
};

} // namespace hyalite::reference
