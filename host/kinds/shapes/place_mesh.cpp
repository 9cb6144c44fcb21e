#include "kinds/shapes/place_mesh.h"

#include "scene/model/bounds.h"
#include "scene/model/quadric.h"
#include "scene/model/scene_limits.h"

namespace hyalite::kinds {

MeshInstance placedMesh(const Reader& reader, const Surroundings& around, std::size_t mesh,
                        const glm::dmat4& toObject) {
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

} // namespace hyalite::kinds
