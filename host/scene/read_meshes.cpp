// See read_meshes.h.
#include "scene/read_meshes.h"

#include "scene/bounds.h"
#include "scene/teapot.h"

namespace hyalite {
namespace {

MeshInstance placedMesh(const Reader& reader, const Surroundings& around, std::size_t mesh) {
    const MeshInstance instance{mesh, around.placement.objectToWorld};
    const Bounds box = meshBounds(around.meshes.at(mesh), instance.objectToWorld);
    checkReach(reader, box);
    if (!(glm::length(box.high - box.low) >= kSmallestLength)) {
        reader.map().fail("with its transform this mesh is a single point");
    }
    return instance;
}

} // namespace

Shape readMesh(Reader& reader, const Surroundings& around) {
    const Value file = reader.require("file");
    reader.finish(); // before a large file is read for nothing
    return placedMesh(reader, around, around.meshes.load(file));
}

Shape readTeapot(Reader& reader, const Surroundings& around) {
    constexpr Range kLevels{1, kHighestTeapotLevel};
    std::uint32_t level = 6;
    reader.optional("level", level, kLevels);
    return placedMesh(reader, around, around.meshes.loadTeapot(level));
}

} // namespace hyalite
