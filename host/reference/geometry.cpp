// The elementary shapes, each from the paper named in the header.
#include "reference/geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyalite::reference {

std::optional<ShapeHit> intersectSphere(const Ray& ray, const Sphere& sphere) {
    // t^2 - 2 b t + c = 0. The discriminant is taken from the distance of ray and centre, which stays exact where
    // b^2 - c would lose all digits (a small sphere far away); the smaller root from c / q, not from b - sqrt.
    const glm::dvec3 f = ray.origin - sphere.center;
    const double b = -glm::dot(f, ray.direction);
    const glm::dvec3 closest = f + b * ray.direction;
    const double discriminant = sphere.radius * sphere.radius - glm::dot(closest, closest);
    if (discriminant < 0) {
        return std::nullopt;
    }
    const double c = glm::dot(f, f) - sphere.radius * sphere.radius;
    const double q = b + std::copysign(std::sqrt(discriminant), b);
    if (q == 0) { // touches the sphere at the ray's own origin
        return std::nullopt;
    }
    const auto [first, second] = std::minmax({c / q, q});
    for (const double t : {first, second}) {
        if (inRange(t, ray)) {
            return ShapeHit{.t = t};
        }
    }
    return std::nullopt;
}

SurfacePoint surfaceAt(const Sphere& sphere, const Ray& ray, const ShapeHit& hit) {
    const glm::dvec3 normal = glm::normalize(ray.origin + hit.t * ray.direction - sphere.center);
    return {.position = sphere.center + sphere.radius * normal,
            .geometricNormal = normal,
            .normal = normal,
            .offset = surfaceOffset(glm::length(sphere.center) + sphere.radius)};
}

std::optional<ShapeHit> intersectQuad(const Ray& ray, const Quad& quad) {
    const glm::dvec3 n = glm::cross(quad.edge0, quad.edge1);
    const double t = glm::dot(n, quad.corner - ray.origin) / glm::dot(n, ray.direction);
    if (!inRange(t, ray)) { // also where the ray is parallel to the plane: t is infinite or NaN
        return std::nullopt;
    }
    // p = u e0 + v e1, hence p x e1 = u n and e0 x p = v n.
    const glm::dvec3 p = ray.origin + t * ray.direction - quad.corner;
    const double u = glm::dot(glm::cross(p, quad.edge1), n) / glm::dot(n, n);
    const double v = glm::dot(glm::cross(quad.edge0, p), n) / glm::dot(n, n);
    if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1)) {
        return std::nullopt;
    }
    return ShapeHit{.t = t, .u = u, .v = v};
}

SurfacePoint surfaceAt(const Quad& quad, const Ray& /*ray*/, const ShapeHit& hit) {
    const glm::dvec3 normal = glm::normalize(glm::cross(quad.edge0, quad.edge1));
    const double scale = glm::length(quad.corner) + glm::length(quad.edge0) + glm::length(quad.edge1);
    return {.position = quad.corner + hit.u * quad.edge0 + hit.v * quad.edge1,
            .geometricNormal = normal,
            .normal = normal,
            .offset = surfaceOffset(scale)};
}

} // namespace hyalite::reference
