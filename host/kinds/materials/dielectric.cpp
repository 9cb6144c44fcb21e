// Glass: shaders/bsdf/dielectric.glsl, host/reference/bsdf/dielectric.cpp.
#include "kinds/materials/material_kinds.h"

#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kIndex{.name = "ior",
                        .range = kIor,
                        .defaultText = "1.5",
                        .text = "refractive index inside over outside, e.g. of glass or water; with `priority`, over "
                                "vacuum. Unless it is thin, the surface must be closed with its normals outward"};
constexpr KeyDoc kRoughness = roughnessKey("0: clear glass; above 0: frosted");
constexpr KeyDoc kAbsorption{.name = "absorption",
                             .type = KeyType::Color,
                             .range = {0, 1e9, true, true, "1/m"},
                             .defaultText = "0",
                             .text = "absorption coefficient σ inside: after t metres, e^(-σ t) of the light is left"};
constexpr KeyDoc kPriority{.name = "priority",
                           .type = KeyType::WholeNumber,
                           .range = {1, 1000000},
                           .text = "where volumes with priorities overlap, the highest one fills the place, and "
                                   "`ior` is relative to vacuum"};
constexpr KeyDoc kThin{.name = "thin",
                       .type = KeyType::Flag,
                       .defaultText = "false",
                       .text = "both faces of a pane at once: light goes straight through, and nothing absorbs it"};
constexpr std::array kKeys{kIndex, kRoughness, kAbsorption, kPriority, kThin};

// Thin glass has no inside, and its faces are smooth.
void refuseWithThin(Reader& reader, const KeyDoc& key, bool isSet) {
    if (isSet) {
        reader.require(key.name).fail("thin glass has no '" + std::string(key.name) + "'",
                                      "remove it, or model both faces of the glass");
    }
}

MaterialModel read(Reader& reader, const Scene& /*scene*/, Material& /*has no textures*/) {
    Dielectric dielectric;
    readKey(reader, kIndex, dielectric.ior);
    readKey(reader, kRoughness, dielectric.roughness);
    readKey(reader, kAbsorption, dielectric.absorption);
    readKey(reader, kPriority, dielectric.priority);
    readKey(reader, kThin, dielectric.thin);
    if (dielectric.thin) {
        refuseWithThin(reader, kRoughness, dielectric.roughness > 0);
        refuseWithThin(reader, kAbsorption, dielectric.absorption != glm::dvec3(0));
        refuseWithThin(reader, kPriority, dielectric.priority > 0);
    }
    return dielectric;
}

void record(const MaterialModel& model, shared::MaterialRecord& r) {
    r.ior = static_cast<float>(model.ior);
    r.roughness = static_cast<float>(model.roughness);
    r.absorption = model.absorption;
    r.priority = model.priority;
    r.thin = model.thin;
}

} // namespace

constinit const MaterialKind kDielectricMaterial{
    .doc = {.type = "dielectric", .schemaName = "dielectric", .keys = kKeys},
    .read = read,
    .record = record,
    .reference = &reference::kDielectricBsdf};

} // namespace hyalite::kinds
