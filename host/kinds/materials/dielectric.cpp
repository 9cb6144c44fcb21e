// Glass: shaders/bsdf/dielectric.glsl, host/reference/bsdf/dielectric.cpp.
#include "kinds/materials/material_kinds.h"

#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kIndex{.name = "ior",
                        .range = kIor,
                        .defaultText = "1.5",
                        .text = "refractive index inside over outside, e.g. of glass or water; the surface must be "
                                "closed with its normals outward"};
constexpr KeyDoc kRoughness = roughnessKey("0: clear glass; above 0: frosted");
constexpr KeyDoc kAbsorption{.name = "absorption",
                             .type = KeyType::Color,
                             .range = {0, 1e9, true, true, "1/m"},
                             .defaultText = "0",
                             .text = "absorption coefficient σ inside: after t metres, e^(-σ t) of the light is left"};
constexpr std::array kKeys{kIndex, kRoughness, kAbsorption};

MaterialModel read(Reader& reader, const Scene& /*scene*/, Material& /*has no textures*/) {
    Dielectric dielectric;
    readKey(reader, kIndex, dielectric.ior);
    readKey(reader, kRoughness, dielectric.roughness);
    readKey(reader, kAbsorption, dielectric.absorption);
    return dielectric;
}

void record(const MaterialModel& model, shared::MaterialRecord& r) {
    r.ior = static_cast<float>(model.ior);
    r.roughness = static_cast<float>(model.roughness);
    r.absorption = model.absorption;
}

} // namespace

constinit const MaterialKind kDielectricMaterial{
    .doc = {.type = "dielectric", .schemaName = "dielectric", .keys = kKeys},
    .read = read,
    .record = record,
    .reference = &reference::kDielectricBsdf};

} // namespace hyalite::kinds
