// Metal with the complex index eta + i k.
#include "reference/bsdf/bsdf_model.h"
#include "reference/bsdf/fresnel.h"

namespace hyalite::reference {

namespace {

std::uint32_t flags(const MaterialModel& material) {
    return lobeFlag(material.roughness);
}

Lobe lobe(const MaterialModel& material, bool /*front*/) {
    return {.material = material, .alpha = facetAlpha(material.roughness)};
}

glm::dvec3 reflectance(const Lobe& lobe, double cosine) {
    const MaterialModel& metal = lobe.material;
    return {fresnelConductor(cosine, metal.eta.x, metal.k.x), fresnelConductor(cosine, metal.eta.y, metal.k.y),
            fresnelConductor(cosine, metal.eta.z, metal.k.z)};
}

} // namespace

const BsdfModel kConductorBsdf{
    .flags = flags,
    .lobe = lobe,
    .reflectance = reflectance,
};

} // namespace hyalite::reference
