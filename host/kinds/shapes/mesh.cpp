// Meshes from files. Device: shaders/shapes/mesh.glsl; reference: host/reference/shapes/{instance,triangle}.cpp.
#include "base/input_file.h"
#include "kinds/shapes/object_record.h"
#include "kinds/shapes/place_mesh.h"
#include "kinds/shapes/shape_kinds.h"
#include "scene/import/mesh_import.h"
#include "scene/model/affine.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/read_textures.h"

#include <array>
#include <optional>
#include <span>
#include <string>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kFile{.name = "file",
                       .type = KeyType::Text,
                       .required = true,
                       .text = "OBJ, PLY, STL or glTF file; path relative to the scene file",
                       .schema = R"({"type": "string",
          "pattern": "\\.([oO][bB][jJ]|[pP][lL][yY]|[sS][tT][lL]|[gG][lL][tT][fF]|[gG][lL][bB])$"})"};
constexpr std::array kKeys{kFile};

// Adds a texture of the mesh file to the scene. Each material gets its own copy: few files share textures.
std::optional<std::size_t> sceneTexture(const Value& file, const std::optional<ImportedTexture>& texture,
                                        Encoding encoding, Scene& scene) {
    if (!texture) {
        return std::nullopt;
    }
    const std::string name = file.text() + ' ' + texture->place;
    if (!texture->refusal.empty()) {
        file.fail(texture->place + ": this texture is not supported: " + texture->refusal,
                  "give the object a material of the scene");
    }
    const bool isFile = !texture->file.empty();
    const std::string bytes =
        isFile ? readInputFile(texture->file, kLargestTextureFile, "texture", file.where()) : texture->bytes;
    scene.textures.push_back(
        {name, decodeTexture(std::as_bytes(std::span(bytes)), isFile ? texture->file.string() : name, encoding)});
    return scene.textures.size() - 1;
}

// Index in the scene of a material of the file; the first use adds it to the scene.
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
            file.fail(part.name + ": the transform of this part is singular: it has no inverse");
        }
        Object object;
        object.where = reader.where();
        object.shape = placedMesh(reader, around, part.mesh, part.toFile);
        object.material = around.material;
        if (!object.material) {
            if (!part.material) {
                file.fail(part.name + ": this part has no material", "give one to the object");
            }
            object.material = sceneMaterial(file, *part.material, around, parts);
        }
        around.parts->push_back(std::move(object));
    }
}

Shape read(Reader& reader, const Surroundings& around) {
    const Value file = reader.require(kFile.name);
    reader.finish(); // report a wrong key before reading a large file
    if (around.parts != nullptr && isGltf(file.text())) {
        readParts(reader, file, around);
        return around.parts->front().shape;
    }
    return placedMesh(reader, around, around.meshes.load(file));
}

} // namespace

ObjectRecord record(const MeshInstance& instance, ObjectTables& tables) {
    const bool isSmooth = !tables.scene.meshes[instance.mesh].normals.empty();
    ObjectRecord r{.type = shared::kShapeMesh | (isSmooth ? shared::kShapeSmooth : 0),
                   .root = tables.meshRoots[instance.mesh]};
    const glm::dmat4 toObject = glm::inverse(instance.objectToWorld);
    for (int i = 0; i < 3; ++i) {
        r.texels[static_cast<std::size_t>(i)] = row(toObject, i);
    }
    r.instance = {.row0 = row(instance.objectToWorld, 0),
                  .row1 = row(instance.objectToWorld, 1),
                  .row2 = row(instance.objectToWorld, 2),
                  .neighbors = {},
                  .neighborCount = 0};
    return r;
}

constinit const ShapeKind kMeshShape{
    .doc = {.type = "mesh",
            .schemaName = "mesh",
            .text =
                "A `mesh` is a Wavefront OBJ file (`.obj`), a PLY file (`.ply`: ascii, binary little endian or big "
                "endian), an STL file (`.stl`: text or binary; equal corners are welded, shading is flat) or a glTF "
                "file. Objects that name the same file share one copy. Seen from the front, corners are "
                "counter-clockwise. Faces with vertex normals are shaded smooth, faces without them flat. Polygons "
                "must be convex (or have four corners) and are cut into a fan of triangles.",
            .keys = kKeys},
    .read = read,
    .makesParts = true};

} // namespace hyalite::kinds
