// See load_scene.h. The top level of the format: its sections, its objects, and the checks of the whole scene.
#include "scene/load/load_scene.h"

#include "base/input_file.h"
#include "kinds/lights/area.h"
#include "reference/media/media_depth.h"
#include "scene/checks/glass_check.h"
#include "scene/load/read_lights.h"
#include "scene/load/read_materials.h"
#include "scene/load/read_shapes.h"
#include "scene/load/repeated_objects.h"
#include "scene/model/bounds.h"
#include "scene/model/recentre.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/find_material.h"
#include "scene/yaml/mesh_library.h"
#include "scene/yaml/read_textures.h"
#include "scene/yaml/read_transform.h"
#include "scene/yaml/reader.h"
#include "scene/yaml/settings.h"
#include "scene/yaml/yaml_tree.h"

#include <algorithm>
#include <iterator>
#include <new>

namespace hyalite {
namespace {

constexpr Range kCopies{1, kMostCopies};

void checkVersion(const Value& version) {
    if (version.node().kind != YamlNode::Kind::Scalar || version.node().text != "1") {
        version.fail("unknown version of the scene format", "this program reads hyalite: 1");
    }
}

void readTextures(const Value& value, const std::filesystem::path& folder, Scene& scene) {
    const Reader map(value); // checks that this is a map; its keys are the names of the textures
    for (const YamlEntry& entry : map.map().node().entries) {
        scene.textures.push_back(readTexture(Value(*entry.value, value.file(), entry.key), folder));
    }
}

void readMaterials(const Value& value, Scene& scene) {
    const Reader map(value); // checks that this is a map; its keys are the names of the materials
    for (const YamlEntry& entry : map.map().node().entries) {
        scene.materials.push_back(readMaterial(Value(*entry.value, value.file(), entry.key), scene));
    }
}

// The kinds of warnings that the file's author knows of.
void readAccepted(const Value& value, Scene& scene) {
    std::vector<Choice<WarningKind>> choices;
    for (const WarningRow& row : kWarningRows) {
        choices.push_back({row.name, row.kind});
    }
    for (const Value& name : value.list()) {
        scene.accepted.insert(choose<WarningKind>(name, "warning", choices));
    }
}

// The transforms of an object's copies: each item of `repeat` multiplies the places so far by powers 0 .. count - 1 of
// its map.
std::vector<glm::dmat4> readRepeat(const Value& value) {
    std::vector<glm::dmat4> places{glm::dmat4(1)};
    for (const Value& item : value.list()) {
        Reader reader(item);
        std::uint32_t count = 1;
        reader.required("count", count, kCopies);
        const glm::dmat4 step = readTransform(reader.require("transform"));
        reader.finish();
        if (places.size() * count > kMostCopies) {
            item.fail("more than " + std::to_string(kMostCopies) + " copies of one object");
        }
        std::vector<glm::dmat4> more;
        glm::dmat4 map(1);
        for (std::uint32_t i = 0; i < count; ++i, map = step * map) {
            for (const glm::dmat4& place : places) {
                more.push_back(map * place);
            }
        }
        places = std::move(more);
    }
    return places;
}

// Reads the object at one place; a mesh file of several parts gives several objects.
std::vector<Object> readCopy(const Value& value, const glm::dmat4& place, Scene& scene, MeshLibrary& meshes) {
    Reader reader(value);
    const Value shape = reader.require("shape");
    std::vector<Object> parts;
    kinds::Surroundings around{.readShape = readShape, .scene = scene, .meshes = meshes, .parts = &parts};
    const auto repeat = reader.find("repeat");
    const auto transform = reader.find("transform");
    around.placement = {place * (transform ? readTransform(*transform) : glm::dmat4(1)),
                        transform ? transform : repeat};
    if (const auto name = reader.find("material")) {
        around.material = findMaterial(*name, scene);
    }
    const kinds::Emission emission = kinds::readEmission(reader);
    reader.finish();
    Object whole = readShape(shape, around);
    if (parts.empty()) {
        parts.push_back(std::move(whole));
    }
    for (Object& object : parts) {
        object.where = reader.where();
        object.emission = emission.radiance;
        object.photonShare = emission.photonShare;
        if (emission.where) {
            kinds::checkEmission(*emission.where, object.shape, scene);
            if (object.emission == glm::dvec3(0)) {
                warn(scene, {WarningKind::UnseenLight, emission.where->where(), "this emission is 0",
                             "leave it out, or give the object a material"});
            }
        }
        // The shapes in a csg were checked when they were read
        if (!object.material && !emission.where && !std::holds_alternative<Csg>(object.shape)) {
            value.fail("this object has neither a material nor an emission",
                       "for a black object use a diffuse material of albedo 0");
        }
    }
    return parts;
}

// The object and its copies.
std::vector<Object> readObject(const Value& value, Scene& scene, MeshLibrary& meshes) {
    Reader reader(value);
    const auto repeat = reader.find("repeat");
    std::vector<Object> objects;
    for (const glm::dmat4& place : repeat ? readRepeat(*repeat) : std::vector{glm::dmat4(1)}) {
        std::vector<Object> parts = readCopy(value, place, scene, meshes);
        std::move(parts.begin(), parts.end(), std::back_inserter(objects));
    }
    return objects;
}

// Checks that concern the scene as a whole.
void checkScene(const Value& root, const Scene& scene) {
    const bool emits = std::any_of(scene.objects.begin(), scene.objects.end(),
                                   [](const Object& object) { return object.emission != glm::dvec3(0); });
    const bool isLit =
        scene.environment || !scene.lights.empty() || !scene.spots.empty() || !scene.directionals.empty();
    if (!isLit && !emits) {
        root.fail("the scene has no light", "add a point light to 'lights' or give a quad an 'emission'");
    }
}

void readScene(const Value& root, const std::filesystem::path& folder, Scene& scene) {
    Reader reader(root);
    checkVersion(reader.require("hyalite"));
    const auto camera = reader.find("camera");
    const auto render = reader.find("render");
    const auto textures = reader.find("textures");
    const auto materials = reader.find("materials");
    const auto lights = reader.find("lights");
    const Value objects = reader.require("objects");
    const auto accept = reader.find("accept");
    reader.finish();

    if (accept) {
        readAccepted(*accept, scene);
    }
    if (camera) {
        readCamera(*camera, scene.camera);
    }
    if (render) {
        readRenderSettings(*render, scene.render);
    }
    if (textures) {
        readTextures(*textures, folder, scene);
    }
    if (materials) {
        readMaterials(*materials, scene);
    }
    if (lights) {
        for (const Value& light : lights->list()) {
            readLight(Value(light.node(), light.file(), "light"), folder, scene);
        }
    }
    MeshLibrary meshes(folder, scene);
    for (const Value& object : objects.list()) {
        std::vector<Object> parts = readObject(Value(object.node(), object.file(), "object"), scene, meshes);
        std::move(parts.begin(), parts.end(), std::back_inserter(scene.objects));
    }
    if (scene.objects.empty()) {
        objects.fail("the scene has no objects");
    }
    checkScene(root, scene);
    checkTextures(scene);
    dropRepeatedObjects(scene);
    checks::turnInsideOutGlass(scene);
    findMeshBounds(scene);
    checks::findOpenGlass(scene);
    checks::findBackToBackFaces(scene);
    reference::checkMediaDepth(scene);
    recentre(scene);
}

} // namespace

Scene loadScene(const std::filesystem::path& file) {
    Scene scene;
    scene.file = file.string();
    try {
        const std::string text = readInputFile(file, kLargestSceneFile, "scene", {});
        const YamlPointer root = parseYaml(text, scene.file);
        readScene(Value(*root, scene.file, "scene"), file.parent_path(), scene);
    } catch (const std::bad_alloc&) {
        throw Error(ExitCode::BadInput, SourceLocation{scene.file, 0, 0}, "the scene does not fit into memory");
    }
    return scene;
}

} // namespace hyalite
