#include "render/upload/material_table.h"

#include "shaders/shared/limits.h"

namespace hyalite::render {

namespace {

shared::MaterialRecord blankRecord(std::uint32_t type, const glm::dvec3& color) {
    shared::MaterialRecord r{};
    r.type = type;
    r.color = color;
    r.ior = 1;
    return r;
}

shared::MaterialRecord record(const Diffuse& diffuse) {
    return blankRecord(shared::kMaterialDiffuse, diffuse.albedo);
}

shared::MaterialRecord record(const Mirror& mirror) {
    return blankRecord(shared::kMaterialMirror, mirror.reflectance);
}

shared::MaterialRecord record(const Dielectric& dielectric) {
    shared::MaterialRecord r = blankRecord(shared::kMaterialDielectric, glm::dvec3(1));
    r.ior = static_cast<float>(dielectric.ior);
    r.roughness = static_cast<float>(dielectric.roughness);
    r.extinction = dielectric.absorption;
    return r;
}

shared::MaterialRecord record(const Conductor& conductor) {
    shared::MaterialRecord r = blankRecord(shared::kMaterialConductor, conductor.eta);
    r.extinction = conductor.k;
    r.roughness = static_cast<float>(conductor.roughness);
    return r;
}

shared::MaterialRecord record(const MetallicRoughness& material) {
    shared::MaterialRecord r = blankRecord(shared::kMaterialMetallicRoughness, material.baseColor);
    r.metallic = static_cast<float>(material.metallic);
    r.roughness = static_cast<float>(material.roughness);
    return r;
}

// Its number is still to come.
shared::MaterialRecord record(const CustomReflectance& custom) {
    shared::MaterialRecord r = blankRecord(shared::kMaterialCustom, glm::dvec3(custom.parameters));
    r.extinction = glm::dvec3(custom.parameters.w, 0, 0);
    r.roughness = static_cast<float>(custom.roughness);
    return r;
}

} // namespace

MaterialTable buildMaterialTable(const std::vector<Material>& materials) {
    MaterialTable table;
    std::uint32_t customNumber = 0; // as customCode() counts them
    for (const Material& material : materials) {
        shared::MaterialRecord r = std::visit([](const auto& model) { return record(model); }, material.model);
        r.colorTexture = static_cast<std::uint32_t>(material.colorTexture.value_or(shared::kNone));
        r.roughnessTexture = static_cast<std::uint32_t>(material.roughnessTexture.value_or(shared::kNone));
        if (r.type == shared::kMaterialCustom) {
            r.extinction.y = static_cast<float>(customNumber++);
        }
        table.types |= 1U << r.type;
        // A texture can only make it smoother
        table.types |= r.roughness * r.roughness >= shared::kSmoothAlpha ? 1U << shared::kMaterialRough : 0;
        table.records.push_back(r);
    }
    return table;
}

} // namespace hyalite::render
