// Custom GLSL of the scene: shaders/bsdf/custom.glsl, host/reference/bsdf/custom.cpp.
#include "kinds/materials/material_kinds.h"
#include "scene/yaml/custom_code.h"

#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kFile{
    .name = "file",
    .type = KeyType::Text,
    .required = true,
    .text = "GLSL file, in the scene file's folder or below. It defines a function of the same name that "
            "returns the fraction of light reflected by its angle; see [experiments](experiments.md)"};
constexpr KeyDoc kParameters{
    .name = "parameters",
    .type = KeyType::Other,
    .defaultText = "[0, 0, 0, 0]",
    .text = "further arguments of the function, after the angle",
    .schema = R"({"type": "array", "items": {"type": "number", "minimum": -1e+30, "maximum": 1e+30}, "maxItems": 4})",
    .typeText = "up to four numbers",
    .rangeText = "[-1e30, 1e30]"};
constexpr KeyDoc kRoughness = roughnessKey("as for a conductor");
constexpr std::array kKeys{kFile, kParameters, kRoughness};

MaterialModel read(Reader& reader, const Scene& /*scene*/, Material& /*has no textures*/) {
    CustomReflectance custom;
    const Value file = reader.require(kFile.name);
    readCodeParameters(reader, custom.parameters);
    readKey(reader, kRoughness, custom.roughness);
    reader.finish();
    custom.code = readCustomCode(file, std::filesystem::path(file.file()).parent_path(), "vec3");
    return custom;
}

void record(const MaterialModel& model, shared::MaterialRecord& r) {
    r.parameters = model.parameters;
    r.roughness = static_cast<float>(model.roughness);
}

} // namespace

constinit const MaterialKind kCustomMaterial{
    .doc = {.type = "custom", .schemaName = "customReflectance", .keys = kKeys},
    .read = read,
    .record = record,
    .reference = &reference::kCustomBsdf};

} // namespace hyalite::kinds
