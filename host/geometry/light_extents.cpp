// See light_extents.h.
#include "geometry/light_extents.h"

#include "scene/model/bounds.h"

#include <algorithm>
#include <cmath>

namespace hyalite {

namespace {

using glm::dvec3;
using std::numbers::pi;

// A spot is estimated as full up to its outer cone, and as nothing this far outside it [rad].
constexpr double kSpotFade = pi / 9;

double channelMean(const dvec3& c) {
    return (c.x + c.y + c.z) / 3;
}

// Irradiance from one half of the environment if it were as bright as the mean of all directions [W/m^2].
double meanIrradiance(const Environment& environment) {
    const Image& image = environment.image;
    double mean = 0;
    for (int y = 0; y < image.height; ++y) {
        const double band = (std::cos(pi * y / image.height) - std::cos(pi * (y + 1) / image.height)) / 2;
        for (int x = 0; x < image.width; ++x) {
            mean += channelMean(dvec3(image.at(x, y))) * band / image.width;
        }
    }
    return pi * mean * environment.scale;
}

LightExtent aroundBox(const Bounds& box) {
    return {.box = box, .center = (box.low + box.high) / 2.0, .radius = glm::length(box.high - box.low) / 2};
}

LightExtent at(const dvec3& position) {
    return {.box = {position, position}, .center = position};
}

LightExtent flat(const Bounds& box, const dvec3& edge0, const dvec3& edge1) {
    LightExtent extent = aroundBox(box);
    extent.axis = glm::normalize(glm::cross(edge0, edge1));
    extent.spread = 0;
    return extent;
}

// Seen from any side, a closed mesh shows a quarter of its area on average; a flat one shows all of it from its front.
LightExtent ofMesh(const Mesh& mesh, const glm::dmat4& objectToWorld, double radiance) {
    LightExtent extent = aroundBox(meshBounds(mesh, objectToWorld));
    const double winding = glm::determinant(glm::dmat3(objectToWorld)) < 0 ? -1 : 1;
    std::vector<dvec3> areas; // normals times area [m^2]
    dvec3 sum(0);
    double area = 0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const dvec3 a(objectToWorld * glm::dvec4(mesh.positions[triangle.x], 1));
        const dvec3 b(objectToWorld * glm::dvec4(mesh.positions[triangle.y], 1));
        const dvec3 c(objectToWorld * glm::dvec4(mesh.positions[triangle.z], 1));
        areas.push_back(glm::cross(b - a, c - a) * (winding / 2));
        sum += areas.back();
        area += glm::length(areas.back());
    }
    const double shown = glm::length(sum);
    extent.intensity = radiance * (area + 3 * shown) / 4;
    if (shown > 1e-6 * area) {
        extent.axis = sum / shown;
        extent.spread = 0;
        for (const dvec3& n : areas) {
            const double cosine = glm::dot(n, extent.axis) / std::max(glm::length(n), 1e-300);
            extent.spread =
                n == dvec3(0) ? extent.spread : std::max(extent.spread, std::acos(std::clamp(cosine, -1.0, 1.0)));
        }
    }
    return extent;
}

LightExtent ofObject(const Scene& scene, const Object& object) {
    const double radiance = channelMean(object.emission);
    if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        LightExtent extent = flat(worldBounds(*quad), quad->edge0, quad->edge1);
        extent.intensity = radiance * glm::length(glm::cross(quad->edge0, quad->edge1));
        return extent;
    }
    if (const auto* disk = std::get_if<Disk>(&object.shape)) {
        LightExtent extent = flat(worldBounds(*disk), disk->axis0, disk->axis1);
        extent.intensity = radiance * pi * glm::length(glm::cross(disk->axis0, disk->axis1));
        return extent;
    }
    if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
        return ofMesh(scene.meshes.at(instance->mesh), instance->objectToWorld, radiance);
    }
    LightExtent extent = aroundBox(worldBounds(scene, object));
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        extent.radius = sphere->radius;
        extent.intensity = radiance * pi * sphere->radius * sphere->radius;
    }
    return extent;
}

} // namespace

std::vector<LightExtent> lightExtents(const Scene& scene) {
    std::vector<LightExtent> extents;
    const auto add = [&](LightExtent extent, double strength, double share) {
        extent.intensity = strength * share;
        extents.push_back(extent);
    };
    if (scene.environment) {
        add({.isFar = true}, meanIrradiance(*scene.environment), scene.environment->photonShare);
    }
    for (const PointLight& point : scene.lights) {
        add(at(point.position), channelMean(point.intensity), point.photonShare);
    }
    for (const SpotLight& spot : scene.spots) {
        LightExtent extent = at(spot.position);
        extent.axis = spot.direction;
        extent.spread = spot.angle * pi / 180;
        extent.fade = kSpotFade;
        add(extent, channelMean(spot.intensity), spot.photonShare);
    }
    for (const DirectionalLight& light : scene.directionals) {
        LightExtent extent{.axis = light.direction, .isFar = true};
        if (light.beam) {
            extent.center = light.beam->center;
            extent.radius = light.beam->radius;
        }
        add(extent, channelMean(light.irradiance), light.photonShare);
    }
    for (const Object& object : scene.objects) {
        if (object.emission != dvec3(0)) {
            const LightExtent extent = ofObject(scene, object);
            add(extent, extent.intensity, object.photonShare);
        }
    }
    return extents;
}

} // namespace hyalite
