// The keys of metallic-roughness, shared with materials that layer over it.
#pragma once

#include "kinds/materials/material_kind.h"

#include <array>

namespace hyalite::kinds {

inline constexpr KeyDoc kBaseColor{.name = "base_color",
                                   .type = KeyType::TexturedColor,
                                   .range = kFraction,
                                   .defaultText = "0.8",
                                   .text = "colour of the diffuse base and of the metal's reflection"};
inline constexpr KeyDoc kMetallic{
    .name = "metallic",
    .range = kFraction,
    .defaultText = "0",
    .text = "0: a dielectric, diffuse under a layer that reflects 4 %; 1: a metal; between: a mixture"};
inline constexpr KeyDoc kBaseRoughness{
    .name = "roughness", .range = kFraction, .defaultText = "0.5", .text = "roughness of that layer or of the metal"};
inline constexpr KeyDoc kMetallicRoughnessTexture{
    .name = "metallic_roughness_texture",
    .type = KeyType::Other,
    .defaultText = "none",
    .text = "a texture whose green multiplies `roughness` and whose blue multiplies `metallic`; "
            "both then default to 1. Its file must be `linear`",
    .schema = R"({"$ref": "#/$defs/textureReference"})",
    .typeText = "`{texture: name}`"};
inline constexpr std::array kMetallicRoughnessKeys{kBaseColor, kMetallic, kBaseRoughness, kMetallicRoughnessTexture};

[[nodiscard]] MetallicRoughness readMetallicRoughness(Reader& reader, const Scene& scene, Material& material);
void recordMetallicRoughness(const MaterialModel& model, shared::MaterialRecord& r);

} // namespace hyalite::kinds
