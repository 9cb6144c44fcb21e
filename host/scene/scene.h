// The scene as a scene file describes it: plain values in double precision, units in the comments. Device buffers
// and the reference renderer are both made from it.
#pragma once

#include "base/error.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace hyalite {

struct Camera {
    glm::dvec3 position{0, 0, 5}; // [m]
    glm::dvec3 lookAt{0, 0, 0};   // [m]
    glm::dvec3 up{0, 1, 0};
    double fov = 45; // vertical [degrees], in (0, 180)
    glm::uvec2 resolution{512, 512};
};

enum class Integrator { Whitted, Ppm };

struct RenderSettings {
    Integrator integrator = Integrator::Ppm;
    std::uint32_t maxDepth =
        12; // ppm: segments of a whole path, 1..255; whitted: reflections and refractions in a row, 0..254
    std::uint32_t passes = 64;      // >= 1
    std::uint32_t photons = 200000; // emitted per pass, >= 1
    std::uint32_t seed = 1;
    double radius =
        0; // ppm: search radius of the first pass [m]; 0: 1/100 of the radius of the scene's bounding sphere
    double alpha = 2.0 / 3.0; // ppm: how much of the photons a shrinking radius keeps [Knaus11], in (0, 1)
    double minWeight =
        1.0 / 1024; // whitted: rays that would add less than this share to the pixel are not followed; 0: all are
};

struct Diffuse {
    glm::dvec3 albedo{0.5}; // [0, 1]
};
struct Mirror {
    glm::dvec3 reflectance{1}; // [0, 1]
};
struct Dielectric {
    double ior = 1.5;     // inside over outside, > 0
    double roughness = 0; // [0, 1]
};
struct Conductor { // metal of the complex index eta + i k
    glm::dvec3 eta{1};
    glm::dvec3 k{0};
    double roughness = 0; // [0, 1]
};
struct MetallicRoughness {     // glTF's model: a metal, a diffuse base under a coat, or a mixture of the two
    glm::dvec3 baseColor{0.8}; // [0, 1]: colour of the diffuse base, and what the metal reflects at normal incidence
    double metallic = 0;       // [0, 1]
    double roughness = 0.5;    // [0, 1]
};
using MaterialModel = std::variant<Diffuse, Mirror, Dielectric, Conductor, MetallicRoughness>;

struct Material {
    std::string name;
    MaterialModel model;
};

struct PointLight {
    glm::dvec3 position{0};  // [m]
    glm::dvec3 intensity{1}; // [W/sr]
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
    glm::dvec3 emission{0};              // quads, disks, spheres: radiance of the front [W/(m^2 sr)]
    SourceLocation where;
};

struct Mesh {
    std::string file;
    std::vector<glm::vec3> positions;  // object space [m]
    std::vector<glm::vec3> normals;    // per position, unit; empty: flat shading
    std::vector<glm::uvec3> triangles; // indices into positions, counter-clockwise from the front
    std::vector<glm::vec2> uvs;        // texture coordinates per position; empty: none
};

struct Scene {
    std::string file;
    Camera camera;
    RenderSettings render;
    std::vector<Material> materials;
    std::vector<PointLight> lights; // emitting objects are lights too
    std::vector<Object> objects;
    std::vector<Object> csgLeaves; // closed shapes, none of them Csg or Quad or Disk; each with its own material
    std::vector<Mesh> meshes;
};

} // namespace hyalite
