// One ray against one shape, in double precision and without cancellation; and how far a ray that leaves a surface
// must start from it.
#pragma once

#include "scene/scene.h"

#include <array>
#include <glm/glm.hpp>
#include <limits>
#include <optional>

namespace hyalite::reference {

struct Ray {
    glm::dvec3 origin;                                     // world [m], already moved off the surface it leaves
    glm::dvec3 direction;                                  // unit
    double tMax = std::numeric_limits<double>::infinity(); // the ray ends here [m]
};

struct Triangle {
    std::array<glm::dvec3, 3> corners; // world [m]
    std::array<glm::dvec3, 3> normals; // world, to be interpolated and normalised: shading normals of the corners
    glm::dvec3 normal;                 // world, unit: the front, counter-clockwise in the mesh's own space
};

// Where a ray meets a shape, with 0 < t <= tMax.
struct ShapeHit {
    double t = 0; // [m]
    double u = 0; // quad: along edge0; triangle: weight of the second corner
    double v = 0; // quad: along edge1; triangle: weight of the third corner
};

[[nodiscard]] std::optional<ShapeHit> intersectSphere(const Ray& ray, const Sphere& sphere); // nearest; [Haines19]
[[nodiscard]] std::optional<ShapeHit> intersectQuad(const Ray& ray, const Quad& quad);
// Watertight: a ray through an edge shared by two triangles hits at least one of them [Woop13].
[[nodiscard]] std::optional<ShapeHit> intersectTriangle(const Ray& ray, const Triangle& triangle);

// Distance [m] that a ray's origin is moved along the normal, away from the surface it leaves. `scale` [m] bounds the
// sum of the lengths that the point was computed from (corner and edges, centre and radius), whose rounding errors add
// up to at most 16 half-ulps of it: 8 in the point itself, 8 in the next intersection with the same shape. Four times
// that keeps the next root on the right side of zero.
[[nodiscard]] constexpr double surfaceOffset(double scale) {
    return 64 * 0x1p-53 * scale;
}

} // namespace hyalite::reference
