// The elementary shapes, each from the paper named in the header.
#include "reference/shapes/geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hyalite::reference {

namespace {

using glm::dvec3;

// Both roots, ascending, anywhere on the line.
std::optional<std::array<double, 2>> sphereRoots(const Ray& ray, const Sphere& sphere) {
    // t^2 - 2 b t + c = 0. The discriminant comes from the distance between ray and centre, which stays accurate where
    // b^2 - c would lose all digits (a small sphere far away); the smaller root comes from c / q, not from b - sqrt.
    const dvec3 f = ray.origin - sphere.center;
    const double b = -glm::dot(f, ray.direction);
    const dvec3 closest = f + b * ray.direction;
    const double discriminant = sphere.radius * sphere.radius - glm::dot(closest, closest);
    if (discriminant < 0) {
        return std::nullopt;
    }
    const double c = glm::dot(f, f) - sphere.radius * sphere.radius;
    const double q = b + std::copysign(std::sqrt(discriminant), b);
    if (q == 0) { // touches the sphere at the ray's own origin
        return std::array{0.0, 0.0};
    }
    return std::array{std::min(c / q, q), std::max(c / q, q)};
}

// Where the ray meets the parallelogram's plane, in coordinates along its edges.
std::optional<ShapeHit> intersectSpan(const Ray& ray, const dvec3& corner, const dvec3& edge0, const dvec3& edge1) {
    const dvec3 n = glm::cross(edge0, edge1);
    const double t = glm::dot(n, corner - ray.origin) / glm::dot(n, ray.direction);
    if (!inRange(t, ray) || std::isinf(t)) { // infinite or NaN: the ray is parallel to the plane
        return std::nullopt;
    }
    // p = u e0 + v e1, hence p x e1 = u n and e0 x p = v n.
    const dvec3 p = ray.origin + t * ray.direction - corner;
    return ShapeHit{.t = t,
                    .u = glm::dot(glm::cross(p, edge1), n) / glm::dot(n, n),
                    .v = glm::dot(glm::cross(edge0, p), n) / glm::dot(n, n)};
}

SurfacePoint pointOfSpan(const dvec3& corner, const dvec3& edge0, const dvec3& edge1, const ShapeHit& hit) {
    const dvec3 normal = glm::normalize(glm::cross(edge0, edge1));
    return {.position = corner + hit.u * edge0 + hit.v * edge1,
            .geometricNormal = normal,
            .normal = normal,
            .offset = surfaceOffset(glm::length(corner) + glm::length(edge0) + glm::length(edge1)),
            .uv = {hit.u, hit.v}};
}

// Longitude and latitude: u = 1/2 faces +z and grows towards +x, v goes from the south pole (-y) to the north pole.
glm::dvec2 globeCoordinates(const dvec3& normal) {
    using std::numbers::pi;
    return {0.5 + std::atan2(normal.x, normal.z) / (2 * pi), 0.5 + std::asin(std::clamp(normal.y, -1.0, 1.0)) / pi};
}

} // namespace

std::optional<ShapeHit> intersectSphere(const Ray& ray, const Sphere& sphere) {
    if (const auto roots = sphereRoots(ray, sphere)) {
        for (const double t : *roots) {
            if (inRange(t, ray)) {
                return ShapeHit{.t = t};
            }
        }
    }
    return std::nullopt;
}

Crossings crossings(const Sphere& sphere, const Ray& line) {
    const auto roots = sphereRoots(line, sphere);
    if (!roots) {
        return {};
    }
    return {{.at = {.t = (*roots)[0]}, .entering = true}, {.at = {.t = (*roots)[1]}, .entering = false}};
}

bool isInside(const Sphere& sphere, const dvec3& point) {
    return glm::length(point - sphere.center) <= sphere.radius;
}

SurfacePoint surfaceAt(const Sphere& sphere, const Ray& ray, const ShapeHit& hit) {
    const dvec3 normal = glm::normalize(ray.origin + hit.t * ray.direction - sphere.center);
    return {.position = sphere.center + sphere.radius * normal,
            .geometricNormal = normal,
            .normal = normal,
            .offset = surfaceOffset(glm::length(sphere.center) + sphere.radius),
            .uv = globeCoordinates(normal)};
}

std::optional<ShapeHit> intersectPlane(const Ray& ray, const Plane& plane) {
    const double t = glm::dot(plane.normal, plane.point - ray.origin) / glm::dot(plane.normal, ray.direction);
    if (!inRange(t, ray) || std::isinf(t)) { // infinite or NaN: the ray is parallel to the plane
        return std::nullopt;
    }
    return ShapeHit{.t = t};
}

Crossings crossings(const Plane& plane, const Ray& line) {
    const double above = glm::dot(plane.normal, line.origin - plane.point);
    const double climb = glm::dot(plane.normal, line.direction);
    if (climb == 0 && above > 0) {
        return {};
    }
    const double t = -above / climb;
    return {{.at = {.t = climb < 0 ? t : -kInfinite}, .entering = true},
            {.at = {.t = climb > 0 ? t : kInfinite}, .entering = false}};
}

bool isInside(const Plane& plane, const dvec3& point) {
    return glm::dot(plane.normal, point - plane.point) <= 0;
}

SurfacePoint surfaceAt(const Plane& plane, const Ray& ray, const ShapeHit& hit) {
    const dvec3 near = ray.origin + hit.t * ray.direction;
    const dvec3 position = near - glm::dot(plane.normal, near - plane.point) * plane.normal;
    return {.position = position,
            .geometricNormal = plane.normal,
            .normal = plane.normal,
            .offset = surfaceOffset(glm::length(plane.point) + glm::length(position))};
}

std::optional<ShapeHit> intersectQuad(const Ray& ray, const Quad& quad) {
    const auto hit = intersectSpan(ray, quad.corner, quad.edge0, quad.edge1);
    const bool within = hit && hit->u >= 0 && hit->u <= 1 && hit->v >= 0 && hit->v <= 1;
    return within ? hit : std::nullopt;
}

SurfacePoint surfaceAt(const Quad& quad, const Ray& /*ray*/, const ShapeHit& hit) {
    return pointOfSpan(quad.corner, quad.edge0, quad.edge1, hit);
}

std::optional<ShapeHit> intersectDisk(const Ray& ray, const Disk& disk) {
    const auto hit = intersectSpan(ray, disk.center, disk.axis0, disk.axis1);
    const bool within = hit && hit->u * hit->u + hit->v * hit->v <= 1;
    return within ? hit : std::nullopt;
}

SurfacePoint surfaceAt(const Disk& disk, const Ray& /*ray*/, const ShapeHit& hit) {
    SurfacePoint point = pointOfSpan(disk.center, disk.axis0, disk.axis1, hit);
    point.uv = (point.uv + 1.0) / 2.0; // of the square around it
    return point;
}

} // namespace hyalite::reference
