// glTF's model: shaders/bsdf/metallic_roughness.glsl, host/reference/bsdf/metallic_roughness.cpp.
#include "kinds/materials/metallic_roughness.h"
#include "kinds/materials/material_kinds.h"

namespace hyalite::kinds {
namespace {

MaterialModel read(Reader& reader, const Scene& scene, Material& material) {
    return readMetallicRoughness(reader, scene, material);
}

void record(const MaterialModel& model, shared::MaterialRecord& r) {
    recordMetallicRoughness(model, r);
}

} // namespace

MetallicRoughness readMetallicRoughness(Reader& reader, const Scene& scene, Material& material) {
    MetallicRoughness model;
    readTextured(reader, kBaseColor, scene, model.baseColor, material);
    if (const auto texture = reader.find(kMetallicRoughnessTexture.name)) {
        material.roughnessTexture = readTextureReference(*texture, scene);
        model.metallic = 1; // to be multiplied by the texture
        model.roughness = 1;
    }
    readKey(reader, kMetallic, model.metallic);
    readKey(reader, kBaseRoughness, model.roughness);
    return model;
}

void recordMetallicRoughness(const MaterialModel& model, shared::MaterialRecord& r) {
    r.color = model.color;
    r.metallic = static_cast<float>(model.metallic);
    r.roughness = static_cast<float>(model.roughness);
}

constinit const MaterialKind kMetallicRoughnessMaterial{
    .doc = {.type = "metallic_roughness", .schemaName = "metallicRoughness", .keys = kMetallicRoughnessKeys},
    .read = read,
    .record = record,
    .reference = &reference::kMetallicRoughnessBsdf};

} // namespace hyalite::kinds
