// See read_meshes.h.
#include "scene/read_meshes.h"

#include "scene/bounds.h"
#include "scene/mesh_import.h"
#include "scene/quadric.h"
#include "scene/read_transform.h"
#include "scene/teapot.h"

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

// Where the file's materials stand in the scene; they are put there when first asked for.
std::size_t sceneMaterial(const Value& file, std::size_t material, const Surroundings& around, MeshParts& parts) {
    if (!parts.firstMaterial) {
        parts.firstMaterial = around.scene.materials.size();
        for (std::size_t i = 0; i < parts.materials.size(); ++i) {
            const std::string name = file.text() + " materials[" + std::to_string(i) + ']';
            around.scene.materials.push_back({name, sceneModel(parts.materials[i])});
        }
    }
    return *parts.firstMaterial + material;
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
