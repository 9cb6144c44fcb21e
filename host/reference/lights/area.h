// Lights with a surface: every point of the front emits the same radiance in all directions.
#pragma once

#include "reference/lights/light_sample.h"
#include "scene/model/scene.h"

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <variant>
#include <vector>

namespace hyalite::reference {

// The triangles of an instance of a mesh, in world space, without the degenerate ones.
struct EmittingMesh {
    struct Triangle {
        std::array<glm::dvec3, 3> corners; // world [m], counter-clockwise from the front, from the mesh's first
        glm::dvec3 normal;                 // unit, of the front
        double offset;                     // distance [m] from the triangle at which a ray starts
    };
    std::vector<Triangle> triangles;
    std::vector<double> cdf; // area up to and including each triangle over the total area; 1 for the last
};

struct AreaLight {
    std::variant<Quad, Disk, Sphere, EmittingMesh> shape;
    double area = 0;     // [m^2]
    glm::dvec3 radiance; // of the front [W/(m^2 sr)]
};

// Throws Error(BadInput) if the shape is not a quad, disk, sphere or mesh.
[[nodiscard]] AreaLight makeAreaLight(const Scene& scene, const Object& object);

// A point on a light's surface, with its normal on the emitting side and the ray offset.
struct LightPoint {
    glm::dvec3 position;
    glm::dvec3 normal;
    double offset = 0;

    [[nodiscard]] glm::dvec3 moved() const { return position + offset * normal; }
};

// Uniform over the area.
[[nodiscard]] LightPoint pointOn(const AreaLight& light, glm::dvec2 uv);

// The same as seen from a receiver: of a sphere, only the hemisphere facing it. areaFacing is the area [m^2] sampled.
[[nodiscard]] LightPoint pointFacing(const AreaLight& light, const glm::dvec3& receiver, glm::dvec2 uv);
[[nodiscard]] double areaFacing(const AreaLight& light);

// True if the ray, ignoring occlusion, hits the front of a quad, disk or sphere. Always false for a mesh.
[[nodiscard]] bool looksAt(const AreaLight& light, const glm::dvec3& origin, const glm::dvec3& direction);

// See light_sample.h.
[[nodiscard]] Offer offerTo(const glm::dvec3& receiver, const AreaLight& light, glm::dvec2 uv);
[[nodiscard]] double pdfToward(const AreaLight& light, const glm::dvec3& direction, double distance,
                               const glm::dvec3& lightNormal);
[[nodiscard]] LightRay emitFrom(const AreaLight& light, glm::dvec2 uOrigin, glm::dvec2 uDirection);
[[nodiscard]] double emissionDensity(const AreaLight& light, const glm::dvec3& normal, const glm::dvec3& direction);
[[nodiscard]] double emissionCosine(const AreaLight& light);
[[nodiscard]] std::optional<StartDisc> startDisc(const AreaLight& light);
[[nodiscard]] glm::dvec3 fluxOf(const AreaLight& light);

} // namespace hyalite::reference
