// See read_materials.h. A new material is a reader here and a row of kMaterials.
#include "scene/read_materials.h"

#include "scene/read_textures.h"
#include "scene/scene_limits.h"

#include <array>

namespace hyalite {
namespace {

constexpr Range kFraction{0, 1};
constexpr Range kIor{0.01, 100}; // glass 1.5, diamond 2.4; below 1: a bubble in glass
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
    reader.optionalColor("absorption", dielectric.absorption, kAbsorption);
    return dielectric;
}

// Sets the material's textures, too.
using ReadModel = MaterialModel (*)(Reader&, const Scene&, Material&);
constexpr std::array<Choice<ReadModel>, 3> kMaterials{{
    {"diffuse", readDiffuse},
    {"mirror", readMirror},
    {"dielectric", readDielectric},
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
