// See bounds.h.
#include "scene/bounds.h"

namespace hyalite {
namespace {

void addShape(Bounds& box, const Scene& /*scene*/, const Sphere& sphere) {
    box.add(sphere.center - sphere.radius);
    box.add(sphere.center + sphere.radius);
}

void addShape(Bounds& box, const Scene& /*scene*/, const Quad& quad) {
    box.add(quad.corner);
    box.add(quad.corner + quad.edge0);
    box.add(quad.corner + quad.edge1);
    box.add(quad.corner + quad.edge0 + quad.edge1);
}

void addShape(Bounds& box, const Scene& scene, const MeshInstance& instance) {
    const Bounds mesh = meshBounds(scene.meshes[instance.mesh], instance.objectToWorld);
    box.add(mesh.low);
    box.add(mesh.high);
}

} // namespace

Bounds meshBounds(const Mesh& mesh, const glm::dmat4& objectToWorld) {
    Bounds box;
    for (const glm::uvec3& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            const glm::dvec3 position(mesh.positions[triangle[corner]]);
            box.add(glm::dvec3(objectToWorld * glm::dvec4(position, 1)));
        }
    }
    return box;
}

Bounds sceneBounds(const Scene& scene) {
    Bounds box;
    for (const Object& object : scene.objects) {
        std::visit([&](const auto& shape) { addShape(box, scene, shape); }, object.shape);
    }
    return box;
}

double sceneRadius(const Scene& scene) {
    const Bounds box = sceneBounds(scene);
    return glm::length(box.high - box.low) / 2;
}

double initialRadius(const Scene& scene) {
    return scene.render.radius > 0 ? scene.render.radius : sceneRadius(scene) / 100;
}

} // namespace hyalite
