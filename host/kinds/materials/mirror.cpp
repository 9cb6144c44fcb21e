// A mirror: shaders/bsdf/mirror.glsl, host/reference/bsdf/mirror.cpp.
#include "kinds/materials/material_kinds.h"

#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kReflectance{.name = "reflectance",
                              .type = KeyType::TexturedColor,
                              .range = kFraction,
                              .defaultText = "1",
                              .text = "fraction of light reflected, all in the mirror direction"};
constexpr std::array kKeys{kReflectance};

MaterialModel read(Reader& reader, const Scene& scene, Material& material) {
    Mirror mirror;
    readTextured(reader, kReflectance, scene, mirror.reflectance, material);
    return mirror;
}

void record(const MaterialModel& model, shared::MaterialRecord& r) {
    r.color = model.color;
}

} // namespace

constinit const MaterialKind kMirrorMaterial{.doc = {.type = "mirror", .schemaName = "mirror", .keys = kKeys},
                                             .read = read,
                                             .record = record,
                                             .reference = &reference::kMirrorBsdf};

} // namespace hyalite::kinds
