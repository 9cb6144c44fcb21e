// See read_meshes.h.
#include "scene/load/read_meshes.h"

#include "base/input_file.h"
#include "scene/import/mesh_import.h"
#include "scene/import/teapot.h"
#include "scene/model/bounds.h"
#include "scene/model/quadric.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/read_textures.h"
#include "scene/yaml/read_transform.h"

namespace hyalite {
namespace {

MeshInstance placedMesh(const Reader& reader, const Surroundings& around, std::size_t mesh,
                        const glm::dmat4& toObject = glm::dmat4(1)) {
    const MeshInstance instance{mesh, around.placement.objectToWorld * toObject};
    // The image of the mesh's box is cheap to find and mostly answers; the triangles themselves have the last word.
    Bounds box = transformed(around.meshes.boundsOf(mesh), instance.objectToWorld);
    if (!isWithinReach(box)) {
        box = meshBounds(around.meshes.at(mesh), instance.objectToWorld);
        checkReach(reader, box);
    }
    if (!(glm::length(box.high - box.low) >= kSmallestLength)) {
        reader.map().fail("with its transform this mesh is a single point");
    }
    return instance;
}

// Puts a texture of the mesh file into the scene. Every material has its own: files that share one are few.
std::optional<std::size_t> sceneTexture(const Value& file, const std::optional<ImportedTexture>& texture,
                                        Encoding encoding, Scene& scene) {
    if (!texture) {
        return std::nullopt;
    }
    const std::string name = file.text() + ' ' + texture->place;
    if (!texture->refusal.empty()) {
        file.fail(texture->place + ": this texture cannot be shown: " + texture->refusal,
                  "give the object a material of the scene");
    }
    const bool isFile = !texture->file.empty();
    const std::string bytes =
        isFile ? readInputFile(texture->file, kLargestTextureFile, "texture", file.where()) : texture->bytes;
    scene.textures.push_back(
        {name, decodeTexture(std::as_bytes(std::span(bytes)), isFile ? texture->file.string() : name, encoding)});
    return scene.textures.size() - 1;
}

// Where a material of the file stands in the scene; it is put there when first asked for.
std::size_t sceneMaterial(const Value& file, std::size_t material, const Surroundings& around, MeshParts& parts) {
    const auto [known, isNew] = parts.sceneMaterials.try_emplace(material, around.scene.materials.size());
    if (isNew) {
        const ImportedMaterial& imported = parts.materials[material];
        Scene& scene = around.scene;
        scene.materials.push_back({file.text() + " materials[" + std::to_string(material) + ']', sceneModel(imported),
                                   sceneTexture(file, imported.baseColorTexture, Encoding::Srgb, scene),
                                   sceneTexture(file, imported.metallicRoughnessTexture, Encoding::Linear, scene)});
    }
    return known->second;
}

void readParts(const Reader& reader, const Value& file, const Surroundings& around) {
    MeshParts& parts = around.meshes.loadParts(file);
    for (const ImportedPart& part : parts.parts) {
        if (!isInvertible(around.placement.objectToWorld * part.toFile)) {
            file.fail(part.name + ": its transforms are singular: they have no inverse");
        }
        Object object;
        object.where = reader.where();
        object.shape = placedMesh(reader, around, part.mesh, part.toFile);
        object.material = around.material;
        if (!object.material) {
            if (!part.material) {
                file.fail(part.name + ": this part of the file has no material", "give one to the object");
            }
            object.material = sceneMaterial(file, *part.material, around, parts);
        }
        around.parts->push_back(std::move(object));
    }
}

} // namespace

Shape readMesh(Reader& reader, const Surroundings& around) {
    const Value file = reader.require("file");
    reader.finish(); // before a large file is read for nothing
    if (around.parts != nullptr && isGltf(file.text())) {
        readParts(reader, file, around);
        return around.parts->front().shape;
    }
    return placedMesh(reader, around, around.meshes.load(file));
}

Shape readTeapot(Reader& reader, const Surroundings& around) {
    constexpr Range kLevels{1, kHighestTeapotLevel};
    std::uint32_t level = 6;
    reader.optional("level", level, kLevels);
    return placedMesh(reader, around, around.meshes.loadTeapot(level));
}

} // namespace hyalite
