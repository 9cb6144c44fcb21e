// See read_materials.h. A new material is a reader here and a row of kMaterials.
#include "scene/read_materials.h"

#include "scene/scene_limits.h"

#include <array>

namespace hyalite {
namespace {

constexpr Range kFraction{0, 1};
constexpr Range kIor{0.01, 100}; // glass 1.5, diamond 2.4; below 1: a bubble in glass
constexpr Range kAbsorption{0, 1 / kSmallestLength, true, true, "1/m"};

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
    reader.optionalColor("absorption", dielectric.absorption, kAbsorption);
    return dielectric;
}

using ReadModel = MaterialModel (*)(Reader&);
constexpr std::array<Choice<ReadModel>, 3> kMaterials{{
    {"diffuse", readDiffuse},
    {"mirror", readMirror},
    {"dielectric", readDielectric},
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
