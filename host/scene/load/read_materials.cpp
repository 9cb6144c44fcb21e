// See read_materials.h. A new material is a reader here and a row of kMaterials.
#include "scene/load/read_materials.h"

#include "scene/model/scene_limits.h"
#include "scene/yaml/custom_code.h"
#include "scene/yaml/read_textures.h"

#include <array>

namespace hyalite {
namespace {

constexpr Range kFraction{0, 1};
constexpr Range kIor{0.01, 100}; // glass 1.5, diamond 2.4; below 1: a bubble in glass
constexpr Range kExtinction{0, 100};
constexpr Range kAbsorption{0, 1 / kSmallestLength, true, true, "1/m"};

MaterialModel readDiffuse(Reader& reader, const Scene& scene, Material& material) {
    Diffuse diffuse;
    readTexturedColor(reader, "albedo", kFraction, scene, diffuse.albedo, material.colorTexture);
    return diffuse;
}

MaterialModel readMirror(Reader& reader, const Scene& scene, Material& material) {
    Mirror mirror;
    readTexturedColor(reader, "reflectance", kFraction, scene, mirror.reflectance, material.colorTexture);
    return mirror;
}

MaterialModel readDielectric(Reader& reader, const Scene& /*scene*/, Material& /*has no textures*/) {
    Dielectric dielectric;
    reader.optional("ior", dielectric.ior, kIor);
    reader.optional("roughness", dielectric.roughness, kFraction);
    reader.optionalColor("absorption", dielectric.absorption, kAbsorption);
    return dielectric;
}

// Complex indices of refraction: measured spectra, averaged over the red, green and blue of linear sRGB.
constexpr std::array<Choice<Conductor>, 4> kMetals{{
    {"gold", {{0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}}},
    {"silver", {{0.155, 0.117, 0.138}, {4.828, 3.122, 2.147}}},
    {"copper", {{0.200, 0.924, 1.102}, {3.913, 2.453, 2.142}}},
    {"aluminium", {{1.657, 0.880, 0.521}, {9.224, 6.270, 4.837}}},
}};

MaterialModel readConductor(Reader& reader, const Scene& /*scene*/, Material& /*has no textures*/) {
    Conductor conductor;
    if (const auto metal = reader.find("metal")) {
        conductor = choose<Conductor>(*metal, "metal", kMetals);
        for (const char* index : {"eta", "k"}) {
            if (const auto value = reader.find(index)) {
                value->fail("'metal' says already what '" + std::string(index) + "' is", "leave out one of the two");
            }
        }
    } else {
        const auto eta = reader.find("eta");
        const auto k = reader.find("k");
        if (!eta || !k) {
            reader.map().fail("a conductor needs its 'metal', or 'eta' and 'k'", "metal: gold");
        }
        eta->readColor(conductor.eta, kIor);
        k->readColor(conductor.k, kExtinction);
    }
    reader.optional("roughness", conductor.roughness, kFraction);
    return conductor;
}

MaterialModel readMetallicRoughness(Reader& reader, const Scene& scene, Material& material) {
    MetallicRoughness model;
    readTexturedColor(reader, "base_color", kFraction, scene, model.baseColor, material.colorTexture);
    if (const auto texture = reader.find("metallic_roughness_texture")) {
        material.roughnessTexture = readTextureReference(*texture, scene);
        model.metallic = 1; // to be multiplied by the texture
        model.roughness = 1;
    }
    reader.optional("metallic", model.metallic, kFraction);
    reader.optional("roughness", model.roughness, kFraction);
    return model;
}

MaterialModel readCustomReflectance(Reader& reader, const Scene& /*scene*/, Material& /*has no textures*/) {
    CustomReflectance custom;
    const Value file = reader.require("file");
    readCodeParameters(reader, custom.parameters);
    reader.optional("roughness", custom.roughness, kFraction);
    reader.finish();
    custom.code = readCustomCode(file, std::filesystem::path(file.file()).parent_path(), "vec3");
    return custom;
}

// Sets the material's textures, too.
using ReadModel = MaterialModel (*)(Reader&, const Scene&, Material&);
constexpr std::array<Choice<ReadModel>, 6> kMaterials{{
    {"diffuse", readDiffuse},
    {"mirror", readMirror},
    {"dielectric", readDielectric},
    {"conductor", readConductor},
    {"metallic_roughness", readMetallicRoughness},
    {"custom", readCustomReflectance},
}};

} // namespace

Material readMaterial(const Value& value, const Scene& scene) {
    Reader reader(value);
    const auto read = choose<ReadModel>(reader.require("type"), "material type", kMaterials);
    Material material;
    material.name = value.name();
    material.model = read(reader, scene, material);
    reader.finish();
    return material;
}

} // namespace hyalite
