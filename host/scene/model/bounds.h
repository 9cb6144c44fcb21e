// How large a scene is: axis-aligned bounds, and the lengths that rendering derives from them.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>

namespace hyalite {

// Bounds of the mesh's triangles in world space.
[[nodiscard]] Bounds meshBounds(const Mesh& mesh, const glm::dmat4& objectToWorld);

// Area of the mesh's triangles in world space [m^2].
[[nodiscard]] double worldArea(const Mesh& mesh, const glm::dmat4& objectToWorld);

// Bounds of a shape in world space that needs no scene to know them.
[[nodiscard]] Bounds worldBounds(const Sphere& sphere);
[[nodiscard]] Bounds worldBounds(const Quad& quad);
[[nodiscard]] Bounds worldBounds(const Disk& disk);
[[nodiscard]] Bounds worldBounds(const Torus& torus);

// Bounds of an object in world space; a box with an infinite side holds a shape without end.
[[nodiscard]] Bounds worldBounds(const Scene& scene, const Object& object);

[[nodiscard]] bool isFinite(const Bounds& box);

// Bounds of all objects in world space that have an end; where none has, of the camera and what it looks at.
[[nodiscard]] Bounds sceneBounds(const Scene& scene);

// Where light from beyond the scene starts: on discs across its direction, each as wide as the sphere that it is to
// reach. That sphere holds all objects that have an end and, where some have none, also the camera and what it looks
// at.
struct LightSphere {
    glm::dvec3 center; // [m]
    double radius;     // [m]
    double distance;   // of the discs from the centre [m]: where objects have no end, beyond such of them as stand near
};
[[nodiscard]] LightSphere lightSphere(const Scene& scene);

// Radius of the scene's bounding sphere [m]: half the diagonal of its bounds.
[[nodiscard]] double sceneRadius(const Scene& scene);

// photonmap: how far from a point the photons of an estimate may lie [m]: render.radius and its caustic_radius or,
// where these are 0, 1/8 and 1/25 of sceneRadius.
[[nodiscard]] double globalSearchRadius(const Scene& scene);
[[nodiscard]] double causticSearchRadius(const Scene& scene);

} // namespace hyalite
