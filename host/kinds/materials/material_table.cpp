// See material_table.h.
#include "kinds/materials/material_table.h"

#include "kinds/materials/material_kinds.h"

#include "shaders/shared/limits.h"

namespace hyalite::kinds {

MaterialTable buildMaterialTable(const std::vector<Material>& materials) {
    MaterialTable table;
    std::uint32_t functions = 0; // as customCode() counts them
    for (const Material& material : materials) {
        const MaterialModel& model = material.model;
        shared::MaterialRecord r{};
        r.type = model.type;
        r.ior = 1;
        float roughness = 0;
        if (const MaterialKind* kind = materialKind(model.type)) {
            kind->record(model, r);
            roughness = kind->roughness != nullptr ? kind->roughness(r) : r.roughness;
        }
        r.function = model.code != nullptr ? functions++ : 0;
        r.colorTexture = static_cast<std::uint32_t>(material.colorTexture.value_or(shared::kNone));
        r.roughnessTexture = static_cast<std::uint32_t>(material.roughnessTexture.value_or(shared::kNone));
        table.types |= 1U << r.type;
        table.types |= roughness * roughness >= shared::kSmoothAlpha ? 1U << shared::kMaterialRough : 0;
        table.records.push_back(r);
    }
    return table;
}

} // namespace hyalite::kinds
