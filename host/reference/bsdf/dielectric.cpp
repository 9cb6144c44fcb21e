// Glass: refracts the light that Fresnel's equations do not reflect.
#include "reference/bsdf/bsdf_model.h"
#include "reference/bsdf/interface.h"

#include "shaders/shared/limits.h"

#include <cmath>

namespace hyalite::reference {

namespace {

// Between media of nearly equal index nothing is deflected, however rough the boundary.
double alphaOf(const MaterialModel& material) {
    return std::abs(material.ior - 1) < double{shared::kSmoothIndex} ? 0 : facetAlpha(material.roughness);
}

std::uint32_t flags(const MaterialModel& material) {
    return shared::kBsdfTransmitting | (alphaOf(material) > 0 ? shared::kBsdfGlossy : shared::kBsdfSpecular);
}

Lobe lobe(const MaterialModel& material, bool front) {
    return {.material = material,
            .eta = front ? 1 / material.ior : material.ior,
            .alpha = alphaOf(material),
            .transmits = true};
}

glm::dvec3 reflectance(const Lobe& lobe, double cosine) {
    return glm::dvec3(fresnelDielectric(cosine, lobe.eta));
}

} // namespace

const BsdfModel kDielectricBsdf{
    .flags = flags,
    .lobe = lobe,
    .reflectance = reflectance,
};

} // namespace hyalite::reference
