#include "kinds/shapes/place_mesh.h"

#include "scene/model/bounds.h"
#include "scene/model/quadric.h"
#include "scene/model/scene_limits.h"

#include <glm/gtc/matrix_transform.hpp>

namespace hyalite::kinds {

MeshInstance placedMesh(const Reader& reader, const Surroundings& around, std::size_t mesh,
                        const glm::dmat4& toObject) {
    const glm::dmat4 toFile = glm::translate(glm::dmat4(1), around.meshes.at(mesh).origin);
    const MeshInstance instance{mesh, around.placement.objectToWorld * toObject * toFile};
    // The transformed box of the mesh is cheap and usually passes; only if it fails are the triangles' bounds computed.
    Bounds box = transformed(around.meshes.boundsOf(mesh), instance.objectToWorld);
    if (!isWithinReach(box)) {
        box = meshBounds(around.meshes.at(mesh), instance.objectToWorld);
        checkReach(reader, box);
    }
    if (!(glm::length(box.high - box.low) >= kSmallestLength)) {
        reader.map().fail("after its transform this mesh is a single point");
    }
    return instance;
}

} // namespace hyalite::kinds
