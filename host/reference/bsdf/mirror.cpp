// A smooth surface with the same reflectance at every angle.
#include "reference/bsdf/bsdf_model.h"

namespace hyalite::reference {

namespace {

std::uint32_t flags(const MaterialModel& /*material*/) {
    return shared::kBsdfSpecular;
}

Lobe lobe(const MaterialModel& material, bool /*front*/) {
    return {.material = material};
}

glm::dvec3 reflectance(const Lobe& lobe, double /*cosine*/) {
    return lobe.material.color;
}

} // namespace

const BsdfModel kMirrorBsdf{
    .flags = flags,
    .lobe = lobe,
    .reflectance = reflectance,
};

} // namespace hyalite::reference
