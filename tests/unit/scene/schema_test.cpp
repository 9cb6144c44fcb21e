// The JSON Schema and the documentation have the loader's keys; an unknown key makes the loader list them.
#include "unit/scene/scene_test_support.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

using namespace hyalite;
using namespace hyalite::test;

namespace {

nlohmann::json schema() {
    return nlohmann::json::parse(readFile(kSourceFolder / "scenes/hyalite.schema.json"));
}

// The keys that a scene with the unknown key `unheardof` is told: "known: a, b, c".
std::set<std::string> keysTheLoaderKnows(const std::string& scene) {
    TemporaryFolder folder;
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto error = errorOf([&] { return loadScene(folder.write("scene.yaml", scene)); });
    REQUIRE(error.has_value());
    INFO(error->what());
    REQUIRE(error->hint().starts_with("known: "));
    std::string list = error->hint().substr(7);
    list.erase(std::remove(list.begin(), list.end(), ','), list.end());
    std::istringstream words(list);
    std::set<std::string> keys;
    for (std::string word; words >> word;) {
        keys.insert(word);
    }
    return keys;
}

std::set<std::string> keysOfTheSchema(const std::string& pointer) {
    const nlohmann::json part = schema().at(nlohmann::json::json_pointer(pointer + "/properties"));
    std::set<std::string> keys;
    for (const auto& entry : part.items()) {
        keys.insert(entry.key());
    }
    return keys;
}

// Every key under any "properties" of the schema.
void collectKeys(const nlohmann::json& part, std::set<std::string>& keys) {
    if (part.contains("properties")) {
        for (const auto& entry : part.at("properties").items()) {
            keys.insert(entry.key());
        }
    }
    for (const auto& child : part) {
        if (child.is_structured()) {
            collectKeys(child, keys);
        }
    }
}

} // namespace

TEST_CASE("the JSON Schema has exactly the keys that the loader knows") {
    struct Part {
        std::string pointer;
        std::string scene;
    };
    const std::string object = "hyalite: 1\nmaterials: {m: {type: mirror}}\nobjects: [{material: m, ";
    const std::vector<Part> parts{
        {"", "hyalite: 1\nobjects: []\nunheardof: 1\n"},
        {"/$defs/camera", "hyalite: 1\nobjects: []\ncamera: {unheardof: 1}\n"},
        {"/$defs/render", "hyalite: 1\nobjects: []\nrender: {unheardof: 1}\n"},
        {"/$defs/diffuse", "hyalite: 1\nobjects: []\nmaterials: {m: {type: diffuse, unheardof: 1}}\n"},
        {"/$defs/mirror", "hyalite: 1\nobjects: []\nmaterials: {m: {type: mirror, unheardof: 1}}\n"},
        {"/$defs/dielectric", "hyalite: 1\nobjects: []\nmaterials: {m: {type: dielectric, unheardof: 1}}\n"},
        {"/$defs/conductor", "hyalite: 1\nobjects: []\nmaterials: {m: {type: conductor, metal: gold, unheardof: 1}}\n"},
        {"/$defs/metallicRoughness",
         "hyalite: 1\nobjects: []\nmaterials: {m: {type: metallic_roughness, unheardof: 1}}\n"},
        {"/$defs/clearCoat", "hyalite: 1\nobjects: []\nmaterials: {m: {type: clear_coat, unheardof: 1}}\n"},
        {"/$defs/customReflectance",
         "hyalite: 1\nobjects: []\nmaterials: {m: {type: custom, file: t.glsl, unheardof: 1}}\n"},
        {"/$defs/checker", "hyalite: 1\nobjects: []\ntextures: {t: {type: checker, unheardof: 1}}\n"},
        {"/$defs/imageTexture", "hyalite: 1\nobjects: []\ntextures: {t: {type: image, file: t.png, unheardof: 1}}\n"},
        {"/$defs/customTexture",
         "hyalite: 1\nobjects: []\ntextures: {t: {type: custom, file: t.glsl, unheardof: 1}}\n"},
        {"/$defs/textureReference", "hyalite: 1\nobjects: []\ntextures: {t: {type: checker}}\n"
                                    "materials: {m: {type: mirror, reflectance: {texture: t, unheardof: 1}}}\n"},
        {"/$defs/pointLight", "hyalite: 1\nobjects: []\nlights: [{type: point, position: [0, 0, 0], unheardof: 1}]\n"},
        {"/$defs/spotLight", "hyalite: 1\nobjects: []\nlights: [{type: spot, position: [0, 0, 0], "
                             "direction: [0, 1, 0], unheardof: 1}]\n"},
        {"/$defs/directionalLight",
         "hyalite: 1\nobjects: []\nlights: [{type: directional, direction: [0, 1, 0], unheardof: 1}]\n"},
        {"/$defs/environment", "hyalite: 1\nobjects: []\nlights: [{type: environment, unheardof: 1}]\n"},
        {"/$defs/skyLight", "hyalite: 1\nobjects: []\nlights: [{type: sky, sun: [0, 1, 0], unheardof: 1}]\n"},
        {"/$defs/sphere", object + "shape: {type: csg, op: union, left: {type: sphere, radius: 1, unheardof: 1}, "
                                   "right: {type: sphere, radius: 1}}}]\n"},
        {"/$defs/object", object + "shape: {type: sphere, radius: 1}, unheardof: 1}]\n"},
        {"/$defs/sphere", object + "shape: {type: sphere, radius: 1, unheardof: 1}}]\n"},
        {"/$defs/quad",
         object + "shape: {type: quad, corner: [0, 0, 0], edges: [[1, 0, 0], [0, 1, 0]], unheardof: 1}}]\n"},
        {"/$defs/mesh", object + "shape: {type: mesh, file: t.obj, unheardof: 1}}]\n"},
        {"/$defs/namedQuadric", object + "shape: {type: ellipsoid, radii: [1, 2, 3], unheardof: 1}}]\n"},
        {"/$defs/namedQuadric", object + "shape: {type: hyperbolic_paraboloid, radii: [1, 2, 3], unheardof: 1}}]\n"},
        {"/$defs/quadric", object + "shape: {type: quadric, coefficients: [1, 0, 0, 0, 1, 0, 0, 1, 0, -1], "
                                    "unheardof: 1}}]\n"},
        {"/$defs/clip",
         object + "shape: {type: ellipsoid, radii: [1, 2, 3], clip: {min: [0, 0, 0], unheardof: 1}}}]\n"},
        {"/$defs/box", object + "shape: {type: box, min: [0, 0, 0], max: [1, 1, 1], unheardof: 1}}]\n"},
        {"/$defs/cylinder",
         object + "shape: {type: cylinder, base: [0, 0, 0], top: [0, 1, 0], radius: 1, unheardof: 1}}]\n"},
        {"/$defs/cone", object + "shape: {type: cone, base: [0, 0, 0], top: [0, 1, 0], radius: 1, unheardof: 1}}]\n"},
        {"/$defs/torus", object + "shape: {type: torus, major: 2, minor: 1, unheardof: 1}}]\n"},
        {"/$defs/plane", object + "shape: {type: plane, point: [0, 0, 0], normal: [0, 1, 0], unheardof: 1}}]\n"},
        {"/$defs/disk", object + "shape: {type: disk, normal: [0, 1, 0], radius: 1, unheardof: 1}}]\n"},
        {"/$defs/teapot", object + "shape: {type: teapot, unheardof: 1}}]\n"},
        {"/$defs/csg", object + "shape: {type: csg, op: union, unheardof: 1, shapes: [{type: sphere, radius: 1}, "
                                "{type: sphere, radius: 2}]}}]\n"},
        {"/$defs/map", object + "shape: {type: sphere, radius: 1}, transform: [{unheardof: 1}]}]\n"},
        {"/$defs/rotate", object + "shape: {type: sphere, radius: 1}, "
                                   "transform: [{rotate: {axis: [1, 0, 0], degrees: 1, unheardof: 1}}]}]\n"},
    };
    for (const Part& part : parts) {
        INFO(part.pointer);
        CHECK(keysTheLoaderKnows(part.scene) == keysOfTheSchema(part.pointer));
    }
    // No part of the schema with keys of its own is missing above.
    std::size_t closedParts = 1;
    const nlohmann::json whole = schema();
    for (const auto& definition : whole.at("$defs")) {
        closedParts += definition.contains("additionalProperties") ? 1 : 0;
    }
    std::set<std::string> asked;
    for (const Part& part : parts) {
        asked.insert(part.pointer);
    }
    CHECK(closedParts == asked.size());
}

TEST_CASE("the documentation describes every key of the schema") {
    const std::string text = readFile(kSourceFolder / "docs/scene-format.md");
    std::set<std::string> keys;
    collectKeys(schema(), keys);
    CHECK(keys.size() > 30);
    for (const std::string& key : keys) {
        INFO(key);
        CHECK(text.find('`' + key + '`') != std::string::npos);
    }
}
