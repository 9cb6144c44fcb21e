// The scene as a scene file describes it: plain values in double precision, units in the comments. Both the device
// buffers and the reference renderer are built from it.
#pragma once

#include "base/error.h"
#include "image/image.h"
#include "scene/model/material_model.h"
#include "scene/model/warning.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace hyalite {

struct Camera {
    glm::dvec3 position{0, 0, 5}; // [m]
    glm::dvec3 lookAt{0, 0, 0};   // [m]
    glm::dvec3 up{0, 1, 0};
    double fov = 45;          // vertical [degrees], in (0, 180)
    double aperture = 0;      // diameter of the lens [m]; 0: a pinhole
    double focusDistance = 0; // along the view to the plane in focus [m]; 0: the distance of lookAt
    glm::uvec2 resolution{512, 512};
};

enum class RandomNumbers { Sobol, Independent };

// Integrator photonmap: two passes, photons from the lights and rays from the eye [Jensen01].
enum class PhotonStructure { Tree, Grid };
enum class PhotonFilter { None, Cone, Gaussian, Custom };
enum class PhotonView { Picture, GlobalMap, CausticMap, Photons, Radius };

struct PhotonMapSettings {
    std::uint32_t causticPhotons = 100000; // aimed at mirrors and glass, besides RenderSettings::photons; 0: none
    bool projectionMap = true;             // aim the caustic photons; false: emit them like the others
    PhotonStructure structure = PhotonStructure::Tree;
    std::uint32_t nearest = 50;        // photons in an estimate from the global map
    std::uint32_t causticNearest = 60; // photons in an estimate from the caustic map
    double causticRadius = 0;          // largest radius of that estimate [m]; 0: by the density of the photons
    PhotonFilter filter = PhotonFilter::None;
    PhotonFilter causticFilter = PhotonFilter::Cone;
    double coneConstant = 1.1;                      // k of the cone filter, >= 1
    std::shared_ptr<const CustomCode> customFilter; // where a filter is Custom: float function(float u)
    bool differentialChecking = false;              // stop an estimate from the caustic map where it would blur an edge
    std::uint32_t gatherRays = 1;      // final-gather rays per sample; 0: indirect light directly from the global map
    bool precomputedIrradiance = true; // final gathering looks up irradiance precomputed at the photons
    std::uint32_t shadowPhotons = 0;   // agreeing shadow photons that replace a shadow ray; 0: trace every ray
    PhotonView view = PhotonView::Picture;
};

struct RenderSettings {
    std::string integrator = "ppm"; // name of a row in scene/model/integrators.h
    std::uint32_t maxDepth = 12; // most segments of a path from light to eye, 1..255; whitted: successive reflections
                                 // and refractions, 0..254
    std::uint32_t passes = 64;   // >= 1; with a target error, the maximum
    double targetError = 0;      // estimated error at which to stop, see docs/metrics.md; 0: none
    std::uint32_t photons = 200000; // emitted per pass, >= 1
    std::uint32_t seed = 1;
    RandomNumbers sampler = RandomNumbers::Sobol;
    double radius =
        0; // [m]; ppm: search radius of the first pass, 0: from the photon density (geometry/search_radius.h);
           // photonmap: largest radius of an estimate, 0: by the density of the photons
    double alpha = 2.0 / 3.0; // ppm: fraction of the photons that a shrinking radius keeps [Knaus11], in (0, 1)
    double minWeight =
        1.0 / 1024; // whitted: rays that would add less than this fraction to the pixel are not traced; 0: trace all
    PhotonMapSettings photonMap;
};

// Two alternating colours, in cubes of world space or in squares of the surface coordinates (u, v).
struct Checker {
    std::array<glm::dvec3, 2> colors{glm::dvec3(0.2), glm::dvec3(0.8)}; // [0, 1]; the first starts at the origin
    double size = 0.1;                                                  // edge of a cell [m], or in units of u and v
    bool inWorld = true;
};
// An image over the unit square of (u, v), v upwards, repeated outside it.
struct ImageTexture {
    std::shared_ptr<const Image> image; // [0, 1]
};
// vec3 function(vec3 position, vec2 uv, vec4 parameters), in [0, 1].
struct CustomTexture {
    std::shared_ptr<const CustomCode> code;
    glm::dvec4 parameters{0};
};
using TextureModel = std::variant<Checker, ImageTexture, CustomTexture>;

struct Texture {
    std::string name;
    TextureModel model;
};

struct Material {
    std::string name;
    MaterialModel model;
    std::optional<std::size_t> colorTexture = {};     // in Scene::textures; multiplies the model's colour
    std::optional<std::size_t> roughnessTexture = {}; // in Scene::textures; green times roughness, blue times metallic
    SourceLocation where = {};
};

// Lights. Photons and light samples are distributed over lights and emitting objects in proportion to power times
// `photonShare` (> 0).
struct PointLight {
    glm::dvec3 position{0};  // [m]
    glm::dvec3 intensity{1}; // [W/sr]
    double photonShare = 1;
    SourceLocation where = {};
};
// Full intensity up to (1 - blend) angle from the axis, none beyond `angle`; between the two, 3 t^2 - 2 t^3 with t
// linear in the cosine.
struct SpotLight {
    glm::dvec3 position{0};         // [m]
    glm::dvec3 direction{0, -1, 0}; // unit, along the axis away from the light
    glm::dvec3 intensity{1};        // on the axis [W/sr]
    double angle = 30;              // from the axis [degrees], in (0, 180]
    double blend = 0.1;             // [0, 1]
    double photonShare = 1;
    SourceLocation where = {};
};
// Parallel light: from beyond the scene onto all of it or, with a beam, a cylinder of light that starts at a disc.
struct DirectionalLight {
    struct Beam {
        glm::dvec3 center{0}; // [m]
        double radius = 1;    // [m], > 0
    };
    glm::dvec3 direction{0, -1, 0};          // unit, in which the light travels
    glm::dvec3 irradiance{1};                // of a surface that faces the light [W/m^2]
    std::optional<Beam> beam = std::nullopt; // nullopt: light everywhere
    double photonShare = 1;
    SourceLocation where = {};
};
// Light from beyond the scene. The image's centre is in direction -z, its upper edge in direction +y; radiance is
// constant over each pixel.
struct Environment {
    Image image;         // equirectangular [W/(m^2 sr)], finite and not negative; one pixel: uniform
    double scale = 1;    // of the image's values
    double rotation = 0; // about +y, counter-clockwise [degrees]
    double photonShare = 1;
    SourceLocation where = {};
};

// Axis-aligned box [m]; empty until a point is added. Its sides may be infinite.
struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    [[nodiscard]] static Bounds everything() {
        return {glm::dvec3(-std::numeric_limits<double>::infinity()),
                glm::dvec3(std::numeric_limits<double>::infinity())};
    }
};

// Shapes. Those without an objectToWorld are in world space: their transform is already applied.
struct Sphere {
    glm::dvec3 center{0}; // [m]
    double radius = 1;    // [m], > 0
};
struct Quad { // parallelogram; front: normal = edge0 x edge1
    glm::dvec3 corner{0};
    glm::dvec3 edge0{1, 0, 0};
    glm::dvec3 edge1{0, 1, 0};
};
struct Disk { // ellipse center + u axis0 + v axis1, u^2 + v^2 <= 1; front: normal = axis0 x axis1
    glm::dvec3 center{0};
    glm::dvec3 axis0{1, 0, 0};
    glm::dvec3 axis1{0, 1, 0};
};
struct Plane { // infinite; as a solid, the half-space behind it
    glm::dvec3 point{0};
    glm::dvec3 normal{0, 1, 0}; // unit; the front
};

// q(x, y, z) = a x^2 + 2b xy + 2c xz + 2d x + e y^2 + 2f yz + 2g y + h z^2 + 2i z + j; inside where q <= 0.
struct QuadricForm {
    double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0, i = 0, j = 0;
};

// The set {q <= 0} within a box. Its surface is that of q and, if capped, the box's faces; otherwise the box only cuts
// the surface of q and leaves it open.
struct Quadric {
    QuadricForm form;                   // object space
    Bounds clip = Bounds::everything(); // object space [m]
    bool capped = true;                 // unused without a clip box
    glm::dmat4 objectToWorld{1.0};      // invertible, affine
};
struct Torus {                     // about the y axis of object space: (sqrt(x^2 + z^2) - major)^2 + y^2 <= minor^2
    double major = 1;              // [m]
    double minor = 0.25;           // [m], in (0, major)
    glm::dmat4 objectToWorld{1.0}; // invertible, affine
};
struct MeshInstance {
    std::size_t mesh = 0;                        // in Scene::meshes
    glm::dmat4 objectToWorld{1.0};               // invertible, affine
    std::optional<Bounds> bounds = std::nullopt; // in world space, if known; see findMeshBounds
};

// Constructive solid geometry: a postfix program over closed shapes. Leaf pushes the next leaf; an operation pops two
// operands (left below right) and pushes its result.
enum class CsgStep : std::uint8_t { Leaf, Union, Intersection, Difference };
struct Csg {
    std::size_t firstLeaf = 0; // in Scene::csgLeaves; the leaves follow in the order of the program
    std::vector<CsgStep> program;
};
inline constexpr std::size_t kMostCsgLeaves = 32; // per tree: the device keeps one inside bit per leaf in a word

using Shape = std::variant<Sphere, Quad, Disk, Plane, Quadric, Torus, MeshInstance, Csg>;

struct Object {
    Shape shape;
    std::optional<std::size_t> material; // in Scene::materials; nullopt: reflects nothing
    glm::dvec3 emission{0};              // quads, disks, spheres, meshes: radiance of the front [W/(m^2 sr)]
    SourceLocation where;
    double photonShare = 1; // used only if the object emits
};

struct Mesh {
    std::string file;
    glm::dvec3 origin{0};               // in the file's coordinates: what positions are relative to [m]
    std::vector<glm::vec3> positions;   // object space [m]
    std::vector<glm::vec3> normals;     // per position, unit; empty: flat shading
    std::vector<glm::uvec3> triangles;  // indices into positions, counter-clockwise seen from the front
    std::vector<glm::vec2> uvs;         // per position, v upwards; empty: none
    std::vector<std::uint32_t> lines{}; // per triangle, of its face in the file; empty: a file without lines
};

struct Scene {
    std::string file;
    glm::dvec3 origin{0}; // in world coordinates: what all positions of the scene are relative to [m]; see recentre.h
    Camera camera;
    RenderSettings render;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::optional<Environment> environment;
    std::vector<PointLight> lights; // emitting objects are lights too
    std::vector<SpotLight> spots;
    std::vector<DirectionalLight> directionals;
    std::vector<Object> objects;
    std::vector<Object> csgLeaves; // closed shapes, none of them Csg or Quad or Disk; each with its own material
    std::vector<Mesh> meshes;
    std::vector<Warning> warnings;  // about the file, without those that it accepts
    std::set<WarningKind> accepted; // kinds of warnings that the file accepts
};

} // namespace hyalite
