// The scene's materials as the kernels read them.
#pragma once

#include "scene/model/scene.h"

#include "shaders/shared/scene_records.h"

#include <vector>

namespace hyalite::kinds {

struct MaterialTable {
    std::vector<shared::MaterialRecord> records; // in the scene's order
    std::uint32_t types = 0; // bit kMaterial… is set for every type in use, kMaterialRough if any lobe is rough

    [[nodiscard]] bool hasRoughLobes() const { return (types >> shared::kMaterialRough & 1U) != 0; }
};

[[nodiscard]] MaterialTable buildMaterialTable(const std::vector<Material>& materials);

} // namespace hyalite::kinds
