// A material as one row: its description for the scene file, its reader, its device record and the matching BSDF of the
// reference. One file per model; shaders/shared/materials.h lists them.
#pragma once

#include "kinds/read_key.h"
#include "reference/bsdf/bsdf_model.h"
#include "scene/model/scene.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/key_doc.h"
#include "scene/yaml/read_textures.h"
#include "scene/yaml/reader.h"

#include "shaders/shared/materials.h"

namespace hyalite::kinds {

struct MaterialKind {
    MapDoc doc;

    // Reads one entry of `materials`; also sets the material's textures. Throws Error(BadInput).
    MaterialModel (*read)(Reader& reader, const Scene& scene, Material& material) = nullptr;

    // Writes the fields that the kernels read for this model. The type is already set, ior is 1, all other fields are
    // 0.
    void (*record)(const MaterialModel& model, shared::MaterialRecord& r) = nullptr;

    // The largest roughness of its lobes; nullptr: the record's roughness. A texture can only reduce it.
    float (*roughness)(const shared::MaterialRecord& r) = nullptr;

    const reference::BsdfModel* reference = nullptr;
};

inline constexpr Range kFraction{0, 1};
inline constexpr Range kIor{0.01, 100}; // glass 1.5, diamond 2.4; below 1: a bubble in glass

// The key of a lobe's roughness.
[[nodiscard]] constexpr KeyDoc roughnessKey(std::string_view text) {
    return {.name = "roughness", .range = kFraction, .defaultText = "0", .text = text};
}

// Reads a colour or a texture as its row describes it.
inline void readTextured(Reader& reader, const KeyDoc& key, const Scene& scene, glm::dvec3& color, Material& material) {
    readTexturedColor(reader, key.name, key.range, scene, color, material.colorTexture);
}

} // namespace hyalite::kinds
