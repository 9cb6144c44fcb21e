// A clear coat over metallic-roughness: shaders/bsdf/clear_coat.glsl, host/reference/bsdf/clear_coat.cpp.
#include "kinds/materials/material_kinds.h"
#include "kinds/materials/metallic_roughness.h"

#include <algorithm>
#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kCoat{
    .name = "coat", .range = kFraction, .defaultText = "1", .text = "fraction of the surface that the coat covers"};
constexpr KeyDoc kCoatRoughness{
    .name = "coat_roughness", .range = kFraction, .defaultText = "0", .text = "roughness of the coat; 0: smooth"};
constexpr KeyDoc kCoatIndex{.name = "coat_ior",
                            .range = {1, 100},
                            .defaultText = "1.5",
                            .text = "refractive index of the coat relative to air"};

constexpr auto kKeys = [] {
    constexpr std::array coat{kCoat, kCoatRoughness, kCoatIndex};
    std::array<KeyDoc, kMetallicRoughnessKeys.size() + coat.size()> all;
    std::ranges::copy(coat, std::ranges::copy(kMetallicRoughnessKeys, all.begin()).out);
    return all;
}();

MaterialModel read(Reader& reader, const Scene& scene, Material& material) {
    MaterialModel model = readMetallicRoughness(reader, scene, material);
    model.type = shared::kMaterialClearCoat;
    model.coat = 1;
    model.coatIor = 1.5;
    readKey(reader, kCoat, model.coat);
    readKey(reader, kCoatRoughness, model.coatRoughness);
    readKey(reader, kCoatIndex, model.coatIor);
    return model;
}

void record(const MaterialModel& model, shared::MaterialRecord& r) {
    recordMetallicRoughness(model, r);
    r.coat = static_cast<float>(model.coat);
    r.coatRoughness = static_cast<float>(model.coatRoughness);
    r.coatIor = static_cast<float>(model.coatIor);
}

float roughest(const shared::MaterialRecord& r) {
    return std::max(r.roughness, r.coatRoughness);
}

} // namespace

constinit const MaterialKind kClearCoatMaterial{.doc = {.type = "clear_coat", .schemaName = "clearCoat", .keys = kKeys},
                                                .read = read,
                                                .record = record,
                                                .roughness = roughest,
                                                .reference = &reference::kClearCoatBsdf};

} // namespace hyalite::kinds
