// Lambert's surface: shaders/bsdf/diffuse.glsl, host/reference/bsdf/diffuse.cpp.
#include "kinds/materials/material_kinds.h"

#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kAlbedo{.name = "albedo",
                         .type = KeyType::TexturedColor,
                         .range = kFraction,
                         .defaultText = "0.5",
                         .text = "fraction of light reflected, equally in all directions (Lambert)"};
constexpr std::array kKeys{kAlbedo};

MaterialModel read(Reader& reader, const Scene& scene, Material& material) {
    Diffuse diffuse;
    readTextured(reader, kAlbedo, scene, diffuse.albedo, material);
    return diffuse;
}

void record(const MaterialModel& model, shared::MaterialRecord& r) {
    r.color = model.color;
}

} // namespace

constinit const MaterialKind kDiffuseMaterial{.doc = {.type = "diffuse", .schemaName = "diffuse", .keys = kKeys},
                                              .read = read,
                                              .record = record,
                                              .reference = &reference::kDiffuseBsdf};

} // namespace hyalite::kinds
