// The scene prepared for ray queries: shapes with inverted transforms, lights with their share of the power, one tree
// over the objects and one over each mesh. Value type; the renderers only read it.
#pragma once

#include "geometry/bounding_sphere.h"
#include "geometry/light_tree.h"
#include "reference/camera/camera.h"
#include "reference/lights/lights.h"
#include "reference/media/touching_objects.h"
#include "reference/shapes/bvh.h"
#include "reference/shapes/csg.h"
#include "reference/shapes/geometry.h"
#include "reference/shapes/solid.h"
#include "scene/model/integrators.h"
#include "scene/model/scene.h"

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace hyalite::reference {

using Geometry = std::variant<Solid, Quad, Disk, CsgTree>;

struct World {
    CameraFrame camera;
    Media cameraMedia; // around the lens
    RenderSettings render;
    CameraPathRules cameraPaths;         // of render.integrator
    bool hasStraightGlass = false;       // see lights/shadow.h
    glm::dvec3 origin{0};                // see Scene::origin
    double sceneRadius = 0;              // of the sphere around all bounded objects [m]
    double surfaceError = 0;             // of positions on surfaces, as the device has them [m]
    double pixelFootprint = 0;           // width of a pixel over the distance from the camera
    double globalRadius = 0;             // photonmap: largest search radius for the global map [m]
    double causticRadius = 0;            // photonmap: the same for the caustic map [m]
    std::vector<BoundingSphere> targets; // of the caustic photons
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Object> objects;
    std::vector<Object> csgLeaves;
    std::vector<Geometry> geometry; // per object
    std::vector<Light> lights;
    LightTree lightTree;
    Neighbors neighbors;                  // see media/touching_objects.h
    bool indicesFromMedia = false;        // a dielectric's index depends on the media on its sides
    std::vector<std::uint32_t> bounded;   // the objects in the tree
    std::vector<std::uint32_t> unbounded; // infinite objects, tested one by one
    Bvh bvh;
};

// Throws Error(BadInput) if the scene cannot be rendered.
[[nodiscard]] World prepareWorld(const Scene& scene);

inline constexpr std::uint32_t kNoLeaf = 0xffffffff;

struct Hit {
    double t = 0; // distance along the ray [m]
    std::uint32_t object = 0;
    std::uint32_t primitive = 0; // the shape's part; this and u, v: see ShapeHit
    double u = 0;
    double v = 0;
    std::uint32_t leaf = kNoLeaf; // CSG: the leaf whose surface was hit, in Scene::csgLeaves
    double spread = 0;            // CSG: see CsgHit
};

// The nearest hit with 0 < t <= tMax; of equally near hits, that of the first object, then of the first triangle.
[[nodiscard]] std::optional<Hit> traceClosest(const World& world, const Ray& ray);

// The ray's nearest hit on one object.
[[nodiscard]] std::optional<Hit> traceObject(const World& world, std::uint32_t object, const Ray& ray);

// True if the open segment between two points, both moved off their surfaces, is unoccluded.
[[nodiscard]] bool traceShadow(const World& world, const glm::dvec3& from, const glm::dvec3& to);

// The surface at a ray's hit.
struct Surface {
    glm::dvec3 position;        // world [m]
    glm::dvec3 geometricNormal; // unit, on the side the ray came from
    glm::dvec3 normal;          // unit, for shading, on the same side; interpolated if the mesh has normals
    bool front = false; // the ray came from outside a solid or mesh, from the side q > 0, from the front of a quad
    double offset = 0;  // distance [m] from the surface at which a leaving ray starts
    const Material* material = nullptr; // of the world; nullptr: absorbs
    glm::dvec2 uv{0};                   // for textures
    glm::dvec3 emission{0};             // radiance towards the ray's origin [W/(m^2 sr)]
    const Quad* quad = nullptr;         // of the world: the parallelogram under this point; nullptr: another shape
    const Disk* disk = nullptr;         // likewise, the disk
};
// The index of its material in World::materials; it must have one.
[[nodiscard]] std::size_t materialNumber(const World& world, const Surface& surface);
[[nodiscard]] Surface evaluateSurface(const World& world, const Ray& ray, const Hit& hit);

// True if the point is inside the object; always false for quads, disks and open quadrics.
[[nodiscard]] bool isInside(const World& world, std::uint32_t object, const glm::dvec3& point);

// Start of a ray that leaves the surface in the direction.
[[nodiscard]] glm::dvec3 leave(const Surface& surface, const glm::dvec3& direction);

} // namespace hyalite::reference
