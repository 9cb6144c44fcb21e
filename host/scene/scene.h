// The scene as a scene file describes it: plain values in double precision, units in the comments. Device buffers
// and the reference renderer are both made from it.
#pragma once

#include "base/error.h"

#include <cstdint>
#include <glm/glm.hpp>
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
    double ior = 1.5; // inside over outside, > 0
};
using MaterialModel = std::variant<Diffuse, Mirror, Dielectric>;

struct Material {
    std::string name;
    MaterialModel model;
};

struct PointLight {
    glm::dvec3 position{0};  // [m]
    glm::dvec3 intensity{1}; // [W/sr]
};

struct Sphere {
    glm::dvec3 center{0}; // [m]
    double radius = 1;    // [m], > 0
};
struct Quad { // parallelogram; front: normal = edge0 x edge1
    glm::dvec3 corner{0};
    glm::dvec3 edge0{1, 0, 0};
    glm::dvec3 edge1{0, 1, 0};
};
struct MeshInstance {
    std::size_t mesh = 0;          // in Scene::meshes
    glm::dmat4 objectToWorld{1.0}; // invertible, affine
};
using Shape = std::variant<Sphere, Quad, MeshInstance>; // transforms of spheres and quads are already applied

struct Object {
    Shape shape;
    std::optional<std::size_t> material; // in Scene::materials; none: reflects nothing
    glm::dvec3 emission{0};              // quads: radiance of the front side [W/(m^2 sr)]
    SourceLocation where;
};

struct Mesh {
    std::string file;
    std::vector<glm::vec3> positions;  // object space [m]
    std::vector<glm::vec3> normals;    // per position, unit; empty: flat shading
    std::vector<glm::uvec3> triangles; // indices into positions, counter-clockwise from the front
};

struct Scene {
    std::string file;
    Camera camera;
    RenderSettings render;
    std::vector<Material> materials;
    std::vector<PointLight> lights; // emitting objects are lights too
    std::vector<Object> objects;
    std::vector<Mesh> meshes;
};

} // namespace hyalite
