// Lambertian surface: reflects its albedo equally in all directions.
#include "reference/bsdf/bsdf_model.h"

namespace hyalite::reference {

namespace {

std::uint32_t flags(const MaterialModel& /*material*/) {
    return shared::kBsdfDiffuse;
}

glm::dvec3 albedo(const MaterialModel& material) {
    return material.color;
}

double overDiffuse(const MaterialModel& /*material*/, double /*cosine*/) {
    return 1;
}

double meanOverDiffuse(const MaterialModel& /*material*/) {
    return 1;
}

} // namespace

const BsdfModel kDiffuseBsdf{
    .flags = flags,
    .albedo = albedo,
    .overDiffuse = overDiffuse,
    .meanOverDiffuse = meanOverDiffuse,
};

} // namespace hyalite::reference
