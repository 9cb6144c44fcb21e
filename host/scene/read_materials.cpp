// See read_materials.h. A new material is a reader here and a row of kMaterials.
#include "scene/read_materials.h"

#include <array>

namespace hyalite {
namespace {

constexpr Range kFraction{0, 1};
constexpr Range kIor{0.01, 100}; // glass 1.5, diamond 2.4; below 1: a bubble in glass
constexpr Range kExtinction{0, 100};

MaterialModel readDiffuse(Reader& reader) {
    Diffuse diffuse;
    reader.optionalColor("albedo", diffuse.albedo, kFraction);
    return diffuse;
}

MaterialModel readMirror(Reader& reader) {
    Mirror mirror;
    reader.optionalColor("reflectance", mirror.reflectance, kFraction);
    return mirror;
}

MaterialModel readDielectric(Reader& reader) {
    Dielectric dielectric;
    reader.optional("ior", dielectric.ior, kIor);
    reader.optional("roughness", dielectric.roughness, kFraction);
    return dielectric;
}

// Complex indices of refraction: measured spectra, averaged over the red, green and blue of linear sRGB.
constexpr std::array<Choice<Conductor>, 4> kMetals{{
    {"gold", {{0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}}},
    {"silver", {{0.155, 0.117, 0.138}, {4.828, 3.122, 2.147}}},
    {"copper", {{0.200, 0.924, 1.102}, {3.913, 2.453, 2.142}}},
    {"aluminium", {{1.657, 0.880, 0.521}, {9.224, 6.270, 4.837}}},
}};

MaterialModel readConductor(Reader& reader) {
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

MaterialModel readMetallicRoughness(Reader& reader) {
    MetallicRoughness material;
    reader.optionalColor("base_color", material.baseColor, kFraction);
    reader.optional("metallic", material.metallic, kFraction);
    reader.optional("roughness", material.roughness, kFraction);
    return material;
}

using ReadModel = MaterialModel (*)(Reader&);
constexpr std::array<Choice<ReadModel>, 5> kMaterials{{
    {"diffuse", readDiffuse},
    {"mirror", readMirror},
    {"dielectric", readDielectric},
    {"conductor", readConductor},
    {"metallic_roughness", readMetallicRoughness},
}};

} // namespace

Material readMaterial(const Value& value) {
    Reader reader(value);
    const auto read = choose<ReadModel>(reader.require("type"), "material type", kMaterials);
    Material material{value.name(), read(reader)};
    reader.finish();
    return material;
}

std::size_t findMaterial(const Value& name, const Scene& scene) {
    const std::string wanted = name.text();
    std::vector<std::string> known;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (scene.materials[i].name == wanted) {
            return i;
        }
        known.push_back(scene.materials[i].name);
    }
    failUnknownWord(name, "material", known);
}

} // namespace hyalite
