// A smooth or microfacet surface whose reflectance is a GLSL function given by the scene.
#include "reference/bsdf/bsdf_model.h"
#include "reference/bsdf/custom_twins.h"

namespace hyalite::reference {

namespace {

std::uint32_t flags(const MaterialModel& material) {
    return lobeFlag(material.roughness);
}

Lobe lobe(const MaterialModel& material, bool /*front*/) {
    return {.material = material, .alpha = facetAlpha(material.roughness)};
}

glm::dvec3 reflectance(const Lobe& lobe, double cosine) {
    const ReflectanceTwin twin = customReflectanceTwin(*lobe.material.code);
    return glm::clamp(twin(cosine, lobe.material.parameters), 0.0, 1.0);
}

} // namespace

const BsdfModel kCustomBsdf{
    .flags = flags,
    .lobe = lobe,
    .reflectance = reflectance,
};

} // namespace hyalite::reference
