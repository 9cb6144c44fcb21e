// The scene as a scene file describes it: plain values in double precision, units in the comments. Device buffers
// and the reference renderer are both made from it.
#pragma once

#include "base/error.h"
#include "image/image.h"
#include "scene/model/material_model.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <optional>
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
    double focusDistance = 0; // along the view to the plane that is sharp [m]; 0: that of lookAt
    glm::uvec2 resolution{512, 512};
};

enum class RandomNumbers { Sobol, Independent };

// Integrator photonmap: two passes, photons from the lights and rays from the eye [Jensen01].
enum class PhotonStructure { Tree, Grid };
enum class PhotonFilter { None, Cone, Gaussian, Custom };
enum class PhotonView { Picture, GlobalMap, CausticMap, Photons, Radius };

struct PhotonMapSettings {
    std::uint32_t causticPhotons = 100000; // aimed at mirrors and glass, besides RenderSettings::photons; 0: none
    bool projectionMap = true;             // aim them; false: emit them like the others
    PhotonStructure structure = PhotonStructure::Tree;
    std::uint32_t nearest = 50;        // photons of one estimate from the global map
    std::uint32_t causticNearest = 60; // and from the caustic map
    double causticRadius = 0;          // they lie no farther than this [m]; 0: 1/25 of the radius of the scene's sphere
    PhotonFilter filter = PhotonFilter::None;
    PhotonFilter causticFilter = PhotonFilter::Cone;
    double coneConstant = 1.1;                      // k of the cone filter, >= 1
    std::shared_ptr<const CustomCode> customFilter; // where a filter is Custom: float function(float u)
    bool differentialChecking = false;              // stop an estimate from the caustic map where it would blur an edge
    std::uint32_t gatherRays = 1;      // of final gathering, per sample; 0: indirect light straight from the global map
    bool precomputedIrradiance = true; // final gathering looks up irradiance computed at the photons beforehand
    std::uint32_t shadowPhotons = 0;   // so many that agree replace a shadow ray; 0: all shadow rays are traced
    PhotonView view = PhotonView::Picture;
};

struct RenderSettings {
    std::string integrator = "ppm"; // a name in scene/model/integrators.h
    std::uint32_t maxDepth =
        12; // ppm, path: segments of a whole path, 1..255; whitted: reflections and refractions in a row, 0..254
    std::uint32_t passes = 64;      // >= 1; with a target error the most there may be
    double targetError = 0;         // estimated error at which to stop, see docs/metrics.md; 0: none
    std::uint32_t photons = 200000; // emitted per pass, >= 1
    std::uint32_t seed = 1;
    RandomNumbers sampler = RandomNumbers::Sobol;
    double radius = 0; // [m]; ppm: search radius of the first pass, 0: 1/100 of the radius of the scene's bounding
                       // sphere; photonmap: the photons of an estimate lie no farther, 0: 1/8 of that radius
    double alpha = 2.0 / 3.0; // ppm: how much of the photons a shrinking radius keeps [Knaus11], in (0, 1)
    double minWeight =
        1.0 / 1024; // whitted: rays that would add less than this share to the pixel are not followed; 0: all are
    PhotonMapSettings photonMap;
};

// Two colours in cubes of the world, or in squares of the surface's coordinates (u, v), by turns.
struct Checker {
    std::array<glm::dvec3, 2> colors{glm::dvec3(0.2), glm::dvec3(0.8)}; // [0, 1]; the first from the origin on
    double size = 0.1;                                                  // edge of a cell [m], or in units of u and v
    bool inWorld = true;
};
// A picture over the unit square of (u, v), v upwards, repeated beyond it.
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
    std::optional<std::size_t> roughnessTexture = {}; // likewise: green times roughness, blue times metallic
};

// Lights, and objects that emit: photons and light samples are theirs in proportion to power times `photonShare` (> 0).
struct PointLight {
    glm::dvec3 position{0};  // [m]
    glm::dvec3 intensity{1}; // [W/sr]
    double photonShare = 1;
};
// Full intensity up to (1 - blend) angle from the axis, none from `angle` on; between them 3 t^2 - 2 t^3, where t goes
// evenly in the cosine.
struct SpotLight {
    glm::dvec3 position{0};         // [m]
    glm::dvec3 direction{0, -1, 0}; // unit, where the axis goes
    glm::dvec3 intensity{1};        // on the axis [W/sr]
    double angle = 30;              // from the axis [degrees], in (0, 180]
    double blend = 0.1;             // [0, 1]
    double photonShare = 1;
};
// Parallel light: all over the scene from beyond it or, with a beam, from a disc on and no wider than it.
struct DirectionalLight {
    struct Beam {
        glm::dvec3 center{0}; // [m]
        double radius = 1;    // [m], > 0
    };
    glm::dvec3 direction{0, -1, 0};          // unit, where the light goes
    glm::dvec3 irradiance{1};                // of a surface that faces it [W/m^2]
    std::optional<Beam> beam = std::nullopt; // none: light everywhere
    double photonShare = 1;
};
// Light from beyond the scene. The middle of the image is seen along -z, its upper edge is +y; radiance is constant
// over each pixel.
struct Environment {
    Image image;         // equirectangular [W/(m^2 sr)], finite and not negative; one pixel: the same everywhere
    double scale = 1;    // of the image's values
    double rotation = 0; // about +y, counter-clockwise [degrees]
    double photonShare = 1;
};

// Axis-aligned box [m]; empty until a point is added, and its sides may be infinite.
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

// Shapes. Those without an objectToWorld have their transform applied already.
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
struct Plane { // without end; as a solid, the half-space behind it
    glm::dvec3 point{0};
    glm::dvec3 normal{0, 1, 0}; // unit; the front
};

// q(x, y, z) = a x^2 + 2b xy + 2c xz + 2d x + e y^2 + 2f yz + 2g y + h z^2 + 2i z + j; inside where q <= 0.
struct QuadricForm {
    double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0, i = 0, j = 0;
};

// The set {q <= 0} within a box. Its surface is that of q and, where it is capped, the box's faces; not capped, the box
// only cuts the surface of q, and nothing closes it.
struct Quadric {
    QuadricForm form;                   // object space
    Bounds clip = Bounds::everything(); // object space [m]
    bool capped = true;                 // of no meaning without a clip
    glm::dmat4 objectToWorld{1.0};      // invertible, affine
};
struct Torus {                     // about the y axis of object space: (sqrt(x^2 + z^2) - major)^2 + y^2 <= minor^2
    double major = 1;              // [m]
    double minor = 0.25;           // [m], in (0, major)
    glm::dmat4 objectToWorld{1.0}; // invertible, affine
};
struct MeshInstance {
    std::size_t mesh = 0;          // in Scene::meshes
    glm::dmat4 objectToWorld{1.0}; // invertible, affine
};

// Constructive solid geometry: a postfix program over closed shapes. Leaf pushes the next leaf, an operation takes two
// operands off the stack (left below right) and pushes what it makes of them.
enum class CsgStep : std::uint8_t { Leaf, Union, Intersection, Difference };
struct Csg {
    std::size_t firstLeaf = 0; // in Scene::csgLeaves; the leaves follow in the order of the program
    std::vector<CsgStep> program;
};
inline constexpr std::size_t kMostCsgLeaves = 32; // of one tree: the device keeps one inside bit for each in a word

using Shape = std::variant<Sphere, Quad, Disk, Plane, Quadric, Torus, MeshInstance, Csg>;

struct Object {
    Shape shape;
    std::optional<std::size_t> material; // in Scene::materials; none: reflects nothing
    glm::dvec3 emission{0};              // quads, disks, spheres, meshes: radiance of the front [W/(m^2 sr)]
    SourceLocation where;
    double photonShare = 1; // where it emits
};

struct Mesh {
    std::string file;
    std::vector<glm::vec3> positions;  // object space [m]
    std::vector<glm::vec3> normals;    // per position, unit; empty: flat shading
    std::vector<glm::uvec3> triangles; // indices into positions, counter-clockwise from the front
    std::vector<glm::vec2> uvs;        // per position, v upwards; empty: none
};

struct Scene {
    std::string file;
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
};

} // namespace hyalite
