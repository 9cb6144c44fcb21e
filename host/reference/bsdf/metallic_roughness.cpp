// glTF's model: a metal, a diffuse base under a dielectric coat, or a mixture of the two. [Shirley97a]'s coat transmits
// 1 - F(cosIn) on entry and 1 - F(cosOut) on exit; the factor 21/20 makes reflected and scattered light sum to 1 for a
// white base.
#include "reference/bsdf/bsdf_model.h"
#include "reference/bsdf/fresnel.h"

namespace hyalite::reference {

namespace {

glm::dvec3 normalReflectance(const MaterialModel& material) {
    return glm::mix(glm::dvec3(0.04), material.color, material.metallic);
}

std::uint32_t flags(const MaterialModel& material) {
    const bool hasBase = (1 - material.metallic) * glm::length(material.color) != 0;
    return lobeFlag(material.roughness) | (hasBase ? shared::kBsdfDiffuse | shared::kBsdfLayered : 0);
}

glm::dvec3 albedo(const MaterialModel& material) {
    return 21.0 / 20 * (1 - material.metallic) * material.color * (1.0 - normalReflectance(material));
}

double overDiffuse(const MaterialModel& /*material*/, double cosine) {
    return coatTransmission(cosine);
}

// 1/21 is the mean of 1 - coatTransmission over the hemisphere, weighted by the cosine.
double meanOverDiffuse(const MaterialModel& /*material*/) {
    return 20.0 / 21;
}

Lobe lobe(const MaterialModel& material, bool /*front*/) {
    return {.material = material, .alpha = facetAlpha(material.roughness)};
}

glm::dvec3 reflectance(const Lobe& lobe, double cosine) {
    return 1.0 - (1.0 - normalReflectance(lobe.material)) * coatTransmission(cosine);
}

} // namespace

const BsdfModel kMetallicRoughnessBsdf{
    .flags = flags,
    .albedo = albedo,
    .overDiffuse = overDiffuse,
    .meanOverDiffuse = meanOverDiffuse,
    .lobe = lobe,
    .reflectance = reflectance,
};

} // namespace hyalite::reference
