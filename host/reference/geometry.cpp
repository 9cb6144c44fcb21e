// The intersections, each from the paper named in the header.
#include "reference/geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyalite::reference {

namespace {

bool inRange(double t, const Ray& ray) {
    return t > 0 && t <= ray.tMax;
}

} // namespace

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

std::optional<ShapeHit> intersectTriangle(const Ray& ray, const Triangle& triangle) {
    // Turn the axes so that the ray runs along its largest component, then shear it onto that axis.
    const glm::dvec3 magnitude = glm::abs(ray.direction);
    const int kz =
        magnitude.x > magnitude.y ? (magnitude.x > magnitude.z ? 0 : 2) : (magnitude.y > magnitude.z ? 1 : 2);
    const int kx = (kz + 1) % 3;
    const int ky = (kz + 2) % 3;
    const double shearX = ray.direction[kx] / ray.direction[kz];
    const double shearY = ray.direction[ky] / ray.direction[kz];
    std::array<glm::dvec3, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 q = triangle.corners[i] - ray.origin;
        p[i] = {q[kx] - shearX * q[kz], q[ky] - shearY * q[kz], q[kz] / ray.direction[kz]};
    }
    // Twice the signed areas that the ray spans with the edges. Neighbours compute exactly opposite values for their
    // common edge, so none of them can lose a ray there; zero counts as inside.
    const double a = p[2].x * p[1].y - p[2].y * p[1].x;
    const double b = p[0].x * p[2].y - p[0].y * p[2].x;
    const double c = p[1].x * p[0].y - p[1].y * p[0].x;
    const double sum = a + b + c;
    if ((std::min({a, b, c}) < 0 && std::max({a, b, c}) > 0) || sum == 0) {
        return std::nullopt;
    }
    const double t = (a * p[0].z + b * p[1].z + c * p[2].z) / sum;
    if (!inRange(t, ray)) {
        return std::nullopt;
    }
    return ShapeHit{.t = t, .u = b / sum, .v = c / sum};
}

} // namespace hyalite::reference
