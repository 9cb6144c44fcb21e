#include "render/upload/material_table.h"

#include "shaders/shared/limits.h"

namespace hyalite::render {

namespace {

shared::MaterialRecord record(const MaterialModel& model) {
    shared::MaterialRecord r{};
    r.type = model.type;
    r.color = model.color;
    r.eta = model.eta;
    r.k = model.k;
    r.absorption = model.absorption;
    r.ior = static_cast<float>(model.ior);
    r.roughness = static_cast<float>(model.roughness);
    r.metallic = static_cast<float>(model.metallic);
    r.parameters = model.parameters;
    return r;
}

} // namespace

MaterialTable buildMaterialTable(const std::vector<Material>& materials) {
    MaterialTable table;
    std::uint32_t customNumber = 0; // as customCode() counts them
    for (const Material& material : materials) {
        shared::MaterialRecord r = record(material.model);
        r.colorTexture = static_cast<std::uint32_t>(material.colorTexture.value_or(shared::kNone));
        r.roughnessTexture = static_cast<std::uint32_t>(material.roughnessTexture.value_or(shared::kNone));
        if (r.type == shared::kMaterialCustom) {
            r.function = customNumber++;
        }
        table.types |= 1U << r.type;
        // A texture can only make it smoother
        table.types |= r.roughness * r.roughness >= shared::kSmoothAlpha ? 1U << shared::kMaterialRough : 0;
        table.records.push_back(r);
    }
    return table;
}

} // namespace hyalite::render
