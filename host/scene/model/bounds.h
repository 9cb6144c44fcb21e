// The extent of a scene: axis-aligned bounds, and the lengths that rendering derives from them.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>

namespace hyalite {

// Bounds of the mesh's triangles in world space.
[[nodiscard]] Bounds meshBounds(const Mesh& mesh, const glm::dmat4& objectToWorld);

// Notes the bounds of every instance, which are asked for often. To be called again after instances or meshes change.
void findMeshBounds(Scene& scene);

// Area of the mesh's triangles in world space [m^2].
[[nodiscard]] double worldArea(const Mesh& mesh, const glm::dmat4& objectToWorld);

// World-space bounds of shapes that refer to nothing else in the scene.
[[nodiscard]] Bounds worldBounds(const Sphere& sphere);
[[nodiscard]] Bounds worldBounds(const Quad& quad);
[[nodiscard]] Bounds worldBounds(const Disk& disk);
[[nodiscard]] Bounds worldBounds(const Torus& torus);

// Bounds of an object in world space, with infinite sides for an unbounded shape.
[[nodiscard]] Bounds worldBounds(const Scene& scene, const Object& object);

[[nodiscard]] bool isFinite(const Bounds& box);

// What the search for a CSG solid's crossings needs to know of its size.
struct CsgExtent {
    glm::dvec3 center{0};                                    // of a sphere around the solid [m]
    double radius = std::numeric_limits<double>::infinity(); // [m]; infinite if the solid is endless
    double reach = 0; // largest coordinate of its tori and meshes [m]: these round in proportion to it
};
[[nodiscard]] CsgExtent csgExtent(const Scene& scene, const Csg& csg);

// World-space bounds of all bounded objects; without any, the bounds of the camera's position and target.
[[nodiscard]] Bounds sceneBounds(const Scene& scene);

// Where light from beyond the scene starts: on a disc perpendicular to its direction, as wide as this sphere. The
// sphere encloses all bounded objects and, if some object is unbounded, also the camera's position and target.
struct LightSphere {
    glm::dvec3 center; // [m]
    double radius;     // [m]
    double distance;   // of the discs from the centre [m]; larger than the radius if some object is unbounded, so that
                       // the discs lie beyond the near part of it
};
[[nodiscard]] LightSphere lightSphere(const Scene& scene);

// Radius of the scene's bounding sphere [m]: half the diagonal of its bounds.
[[nodiscard]] double sceneRadius(const Scene& scene);

// Bound on the distance of hits on bounded objects from the surface [m]: some roundings of their coordinates and of
// rays across the scene.
[[nodiscard]] double surfaceError(const Scene& scene);

// Width of a pixel of the camera over the distance along its view: the square root of the area.
[[nodiscard]] double pixelFootprint(const Camera& camera);

// photonmap: the largest radius of an estimate [m]: render.radius and render.caustic_radius. Where these are 0, 1/8 and
// 1/25 of sceneRadius, or less (largestEstimateFor).
[[nodiscard]] double globalSearchRadius(const Scene& scene);
[[nodiscard]] double causticSearchRadius(const Scene& scene);

} // namespace hyalite
