// A material in one row: what it is in the scene file, how it is read, its record on the device and which BSDF of the
// reference it has. One file a model; the list is that of shaders/shared/materials.h.
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

    // One entry of `materials`; sets the material's textures, too. Throws Error(BadInput).
    MaterialModel (*read)(Reader& reader, const Scene& scene, Material& material) = nullptr;

    // Writes what the kernels read of the model; the rest of the record is 0, but for the type and an ior of 1.
    void (*record)(const MaterialModel& model, shared::MaterialRecord& r) = nullptr;

    // The greatest roughness of its lobes; nullptr: the record's. A texture can only make it smaller.
    float (*roughness)(const shared::MaterialRecord& r) = nullptr;

    const reference::BsdfModel* reference = nullptr;
};

inline constexpr Range kFraction{0, 1};
inline constexpr Range kIor{0.01, 100}; // glass 1.5, diamond 2.4; below 1: a bubble in glass

// The key of a lobe's roughness.
[[nodiscard]] constexpr KeyDoc roughnessKey(std::string_view text) {
    return {.name = "roughness", .range = kFraction, .defaultText = "0", .text = text};
}

// A colour or a texture, as its row describes it.
inline void readTextured(Reader& reader, const KeyDoc& key, const Scene& scene, glm::dvec3& color, Material& material) {
    readTexturedColor(reader, key.name, key.range, scene, color, material.colorTexture);
}

} // namespace hyalite::kinds
