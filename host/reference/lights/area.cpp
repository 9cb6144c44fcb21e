// See area.h.
#include "reference/lights/area.h"

#include "reference/lib/sampling.h"
#include "reference/shapes/affine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace hyalite::reference {

namespace {

using std::numbers::pi;

LightPoint pointOn(const Quad& quad, glm::dvec2 uv) {
    return {.position = pointOnQuad(uv, quad),
            .normal = glm::normalize(glm::cross(quad.edge0, quad.edge1)),
            .offset = surfaceOffset(glm::length(quad.corner) + glm::length(quad.edge0) + glm::length(quad.edge1))};
}
LightPoint pointOn(const Disk& disk, glm::dvec2 uv) {
    const glm::dvec2 at = concentricDisc(uv);
    return {.position = disk.center + at.x * disk.axis0 + at.y * disk.axis1,
            .normal = glm::normalize(glm::cross(disk.axis0, disk.axis1)),
            .offset = surfaceOffset(glm::length(disk.center) + glm::length(disk.axis0) + glm::length(disk.axis1))};
}
LightPoint pointOn(const Sphere& sphere, glm::dvec2 uv) {
    const glm::dvec3 normal = uniformSphere(uv);
    return {.position = sphere.center + sphere.radius * normal,
            .normal = normal,
            .offset = surfaceOffset(glm::length(sphere.center) + sphere.radius)};
}
// Picks a triangle by area, then a point on it: the square root of the first number's remainder gives the distance from
// the first corner, the second number the position along the opposite edge.
LightPoint pointOn(const EmittingMesh& mesh, glm::dvec2 uv) {
    const auto choice = std::upper_bound(mesh.cdf.begin(), mesh.cdf.end() - 1, uv.x);
    const double before = choice == mesh.cdf.begin() ? 0 : *(choice - 1);
    const double s = std::sqrt((uv.x - before) / (*choice - before));
    const EmittingMesh::Triangle& triangle = mesh.triangles[static_cast<std::size_t>(choice - mesh.cdf.begin())];
    const auto& [a, b, c] = triangle.corners;
    return {.position = (1 - s) * a + s * (1 - uv.y) * b + s * uv.y * c,
            .normal = triangle.normal,
            .offset = triangle.offset};
}

double areaOf(const Quad& quad) {
    return glm::length(glm::cross(quad.edge0, quad.edge1));
}
double areaOf(const Disk& disk) {
    return pi * glm::length(glm::cross(disk.axis0, disk.axis1));
}
double areaOf(const Sphere& sphere) {
    return 4 * pi * sphere.radius * sphere.radius;
}

// Where the ray from the origin meets the shape's plane, in coordinates along its edges (axes); none: it never sees the
// front.
std::optional<glm::dvec2> placeOnFront(const glm::dvec3& corner, const glm::dvec3& edge0, const glm::dvec3& edge1,
                                       const glm::dvec3& origin, const glm::dvec3& direction) {
    const double volume = glm::dot(glm::cross(edge0, edge1), direction);
    if (volume >= 0) {
        return std::nullopt;
    }
    // Cramer's rule for corner + u edge0 + v edge1 - t direction = origin
    const glm::dvec3 from = origin - corner;
    if (glm::dot(glm::cross(edge0, edge1), from) <= 0) {
        return std::nullopt;
    }
    return glm::dvec2(glm::dot(glm::cross(from, edge1), direction), glm::dot(glm::cross(edge0, from), direction)) /
           volume;
}

bool looksAt(const Quad& quad, const glm::dvec3& origin, const glm::dvec3& direction) {
    const auto at = placeOnFront(quad.corner, quad.edge0, quad.edge1, origin, direction);
    return at && at->x >= 0 && at->x <= 1 && at->y >= 0 && at->y <= 1;
}
bool looksAt(const Disk& disk, const glm::dvec3& origin, const glm::dvec3& direction) {
    const auto at = placeOnFront(disk.center, disk.axis0, disk.axis1, origin, direction);
    return at && glm::dot(*at, *at) <= 1;
}
bool looksAt(const Sphere& sphere, const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 toCenter = sphere.center - origin;
    return glm::dot(toCenter, direction) > 0 && glm::length(glm::cross(toCenter, direction)) <= sphere.radius;
}
bool looksAt(const EmittingMesh&, const glm::dvec3&, const glm::dvec3&) {
    return false;
}

AreaLight meshLight(const Scene& scene, const MeshInstance& instance, const Object& object) {
    const Mesh& mesh = scene.meshes.at(instance.mesh);
    const Affine map(instance.objectToWorld);
    EmittingMesh light;
    double area = 0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        std::array<glm::dvec3, 3> corners{};
        double reach = 0;
        for (int i = 0; i < 3; ++i) {
            corners.at(static_cast<std::size_t>(i)) = mesh.positions.at(triangle[i]);
            reach = std::max(reach, glm::length(corners.at(static_cast<std::size_t>(i))));
        }
        const glm::dvec3 objectNormal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        for (glm::dvec3& corner : corners) {
            corner = map.pointToWorld(corner);
        }
        if (glm::determinant(map.linear) < 0) { // a mirrored mesh has the opposite winding
            std::swap(corners[1], corners[2]);
        }
        const double part = glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
        if (part > 0) {
            area += part;
            light.cdf.push_back(area);
            light.triangles.push_back({.corners = corners,
                                       .normal = glm::normalize(map.normalToWorld(objectNormal)),
                                       .offset = surfaceOffset(roundingScale(map, corners[0], reach, objectNormal))});
        }
    }
    if (area == 0) {
        throw Error(ExitCode::BadInput, object.where, "this mesh has no area to emit light from");
    }
    for (double& sum : light.cdf) {
        sum /= area;
    }
    return {.shape = std::move(light), .area = area, .radiance = object.emission};
}

} // namespace

AreaLight makeAreaLight(const Scene& scene, const Object& object) {
    if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        return {.shape = *quad, .area = areaOf(*quad), .radiance = object.emission};
    }
    if (const auto* disk = std::get_if<Disk>(&object.shape)) {
        return {.shape = *disk, .area = areaOf(*disk), .radiance = object.emission};
    }
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        return {.shape = *sphere, .area = areaOf(*sphere), .radiance = object.emission};
    }
    if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
        return meshLight(scene, *instance, object);
    }
    throw Error(ExitCode::BadInput, object.where, "only quads, disks, spheres and meshes emit light",
                "give the emission to one of these");
}

LightPoint pointOn(const AreaLight& light, glm::dvec2 uv) {
    return std::visit([&](const auto& shape) { return pointOn(shape, uv); }, light.shape);
}

LightPoint pointFacing(const AreaLight& light, const glm::dvec3& receiver, glm::dvec2 uv) {
    LightPoint y = pointOn(light, uv);
    if (const auto* sphere = std::get_if<Sphere>(&light.shape)) {
        if (glm::dot(y.normal, receiver - sphere->center) < 0) {
            y.normal = -y.normal;
            y.position = sphere->center + sphere->radius * y.normal;
        }
    }
    return y;
}

double areaFacing(const AreaLight& light) {
    return std::holds_alternative<Sphere>(light.shape) ? light.area / 2 : light.area;
}

bool looksAt(const AreaLight& light, const glm::dvec3& origin, const glm::dvec3& direction) {
    return std::visit([&](const auto& shape) { return looksAt(shape, origin, direction); }, light.shape);
}

// An area light emits Le cos(l) per area, and the density of the point is 1 / A.
Offer offerTo(const glm::dvec3& receiver, const AreaLight& light, glm::dvec2 uv) {
    const LightPoint y = pointFacing(light, receiver, uv);
    const double cosLight = glm::dot(y.normal, glm::normalize(receiver - y.position));
    Offer offer = offerFrom(y.position, receiver, light.radiance * (std::max(cosLight, 0.0) * areaFacing(light)));
    // The offset also covers the rounding of the distance, which the rounding of the light's coordinates does not bound
    offer.shadowEnd = y.moved() + surfaceOffset(glm::length(offer.toLight)) * y.normal;
    offer.pdfW = cosLight > 0 ? glm::dot(offer.toLight, offer.toLight) / (cosLight * areaFacing(light)) : 0;
    return offer;
}

double pdfToward(const AreaLight& light, const glm::dvec3& direction, double distance, const glm::dvec3& lightNormal) {
    const double cosLight = -glm::dot(direction, lightNormal);
    return cosLight > 0 ? distance * distance / (cosLight * areaFacing(light)) : 0;
}

LightRay emitFrom(const AreaLight& light, glm::dvec2 uOrigin, glm::dvec2 uDirection) {
    const LightPoint point = pointOn(light, uOrigin);
    const glm::dvec3 direction = cosineHemisphere(uDirection, point.normal);
    return {.origin = point.position,
            .direction = direction,
            .normal = point.normal,
            .offset = point.offset,
            .pdfDirection = emissionDensity(light, point.normal, direction)};
}

double emissionDensity(const AreaLight& /*light*/, const glm::dvec3& normal, const glm::dvec3& direction) {
    return std::max(0.0, glm::dot(normal, direction)) / pi;
}

double emissionCosine(const AreaLight& /*light*/) {
    return 0;
}

std::optional<StartDisc> startDisc(const AreaLight& /*light*/) {
    return std::nullopt;
}

glm::dvec3 fluxOf(const AreaLight& light) {
    return pi * light.area * light.radiance;
}

} // namespace hyalite::reference
