// Lights with a surface, each point of whose front has the same radiance in all directions.
#pragma once

#include "reference/lights/light_sample.h"
#include "scene/model/scene.h"

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <variant>
#include <vector>

namespace hyalite::reference {

// The triangles of a mesh where an instance puts them; none is without area.
struct EmittingMesh {
    struct Triangle {
        std::array<glm::dvec3, 3> corners; // world [m], counter-clockwise from the front, the mesh's first one first
        glm::dvec3 normal;                 // unit, of the front
        double offset;                     // distance [m] that a ray starts from it
    };
    std::vector<Triangle> triangles;
    std::vector<double> cdf; // area up to and including each triangle, over the whole; 1 for the last
};

struct AreaLight {
    std::variant<Quad, Disk, Sphere, EmittingMesh> shape;
    double area = 0;     // [m^2]
    glm::dvec3 radiance; // of the front [W/(m^2 sr)]
};

// Throws Error(BadInput) at an emitting object of another shape than quad, disk, sphere and mesh.
[[nodiscard]] AreaLight makeAreaLight(const Scene& scene, const Object& object);

// A point of a light's surface with its normal on the emitting side, and how far a ray starts from it.
struct LightPoint {
    glm::dvec3 position;
    glm::dvec3 normal;
    double offset = 0;

    [[nodiscard]] glm::dvec3 moved() const { return position + offset * normal; }
};

// Evenly distributed over the area.
[[nodiscard]] LightPoint pointOn(const AreaLight& light, glm::dvec2 uv);

// The same for a receiver: of a sphere only the half that faces it; and the area [m^2] that this chooses from.
[[nodiscard]] LightPoint pointFacing(const AreaLight& light, const glm::dvec3& receiver, glm::dvec2 uv);
[[nodiscard]] double areaFacing(const AreaLight& light);

// Does a ray that nothing stops see the front of a quad, a disk or a sphere? Never that of a mesh.
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
