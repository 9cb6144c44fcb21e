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
    if (material.thin != 0) {
        return {.material = material, .eta = 1, .alpha = 0, .transmits = true};
    }
    return {.material = material,
            .eta = front ? 1 / material.ior : material.ior,
            .alpha = alphaOf(material),
            .transmits = true};
}

glm::dvec3 reflectance(const Lobe& lobe, double cosine) {
    if (lobe.material.thin != 0) { // the sum over all reflections between the two faces
        const double F = fresnelDielectric(cosine, 1 / lobe.material.ior);
        return glm::dvec3(2 * F / (1 + F));
    }
    return glm::dvec3(fresnelDielectric(cosine, lobe.eta));
}

} // namespace

const BsdfModel kDielectricBsdf{
    .flags = flags,
    .lobe = lobe,
    .reflectance = reflectance,
};

} // namespace hyalite::reference
