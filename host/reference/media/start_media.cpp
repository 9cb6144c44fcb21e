// See start_media.h.
#include "reference/media/start_media.h"

#include "geometry/media_needs.h"
#include "reference/world.h"
#include "scene/model/bounds.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hyalite::reference {

namespace {

using glm::dvec3;

// The number of surfaces that a ray out of the scene crosses at most.
constexpr std::uint32_t kMostCrossings = 10000;

// Distance from a light's surface at which its media are looked up, relative to the coordinates there: photons start
// closer to it, and dielectrics that are meant to be apart from it are farther away.
constexpr double kOff = 0x1p-18;

// A point just before the front of an emitting object.
dvec3 pointBefore(const Scene& scene, const Object& object) {
    dvec3 point(0);
    dvec3 normal(0);
    if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        point = quad->corner + 0.5 * (quad->edge0 + quad->edge1);
        normal = glm::cross(quad->edge0, quad->edge1);
    } else if (const auto* disk = std::get_if<Disk>(&object.shape)) {
        point = disk->center;
        normal = glm::cross(disk->axis0, disk->axis1);
    } else if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        normal = dvec3(0.36, 0.8, 0.48);
        point = sphere->center + sphere->radius * normal;
    } else if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
        const Mesh& mesh = scene.meshes.at(instance->mesh);
        for (const glm::uvec3& triangle : mesh.triangles) {
            const auto corner = [&](std::uint32_t i) {
                return dvec3(instance->objectToWorld * glm::dvec4(dvec3(mesh.positions[i]), 1));
            };
            const dvec3 a = corner(triangle.x);
            normal = glm::cross(corner(triangle.y) - a, corner(triangle.z) - a);
            point = (a + corner(triangle.y) + corner(triangle.z)) / 3.0;
            if (normal != dvec3(0)) {
                break;
            }
        }
    }
    const double size = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z), glm::length(normal)});
    return normal == dvec3(0) ? point : point + kOff * size * glm::normalize(normal);
}

bool contains(const Bounds& box, const dvec3& point) {
    return glm::all(glm::lessThanEqual(box.low, point)) && glm::all(glm::lessThanEqual(point, box.high));
}

// The scene's dielectrics alone.
Scene dielectricsOf(const Scene& scene) {
    Scene part;
    part.file = scene.file;
    part.camera = scene.camera;
    part.materials = scene.materials;
    part.csgLeaves = scene.csgLeaves;
    std::map<std::size_t, std::size_t> meshes; // by their index in the scene
    const auto keepMesh = [&](Object& object) {
        if (auto* instance = std::get_if<MeshInstance>(&object.shape)) {
            const auto [entry, isNew] = meshes.try_emplace(instance->mesh, part.meshes.size());
            if (isNew) {
                part.meshes.push_back(scene.meshes.at(instance->mesh));
            }
            instance->mesh = entry->second;
        }
    };
    for (const Object& object : scene.objects) {
        if (isDielectric(scene, object)) {
            part.objects.push_back(object);
            part.objects.back().emission = dvec3(0);
            keepMesh(part.objects.back());
        }
    }
    std::ranges::for_each(part.csgLeaves, keepMesh);
    return part;
}

} // namespace

Media mediaAt(const World& world, const dvec3& point) {
    std::vector<std::uint32_t> entered; // on the way out
    std::vector<std::uint32_t> around;  // the innermost first
    Ray ray{.origin = point, .direction = glm::normalize(dvec3(0.5377, 0.7071, 0.4592))};
    for (std::uint32_t crossing = 0; crossing < kMostCrossings; ++crossing) {
        const std::optional<Hit> hit = traceClosest(world, ray);
        if (!hit) {
            break;
        }
        const Surface surface = evaluateSurface(world, ray, *hit);
        ray = {.origin = leave(surface, ray.direction), .direction = ray.direction};
        if (surface.material == nullptr || surface.material->model.type != shared::kMaterialDielectric ||
            surface.material->model.thin != 0) {
            continue;
        }
        const auto material = static_cast<std::uint32_t>(materialNumber(world, surface));
        if (surface.front) {
            entered.push_back(material);
        } else if (const auto last = std::ranges::find(entered, material); last != entered.end()) {
            entered.erase(last);
        } else {
            around.push_back(material);
        }
    }
    Media media;
    std::for_each(around.rbegin(), around.rend(), [&](std::uint32_t material) { media.enter(material); });
    return media;
}

namespace {

// `around`: the media at a point that the box of some dielectric contains.
template <class Around>
StartMedia collect(const Scene& scene, Around&& around) {
    std::vector<Bounds> boxes;
    for (const Object& object : scene.objects) {
        if (isDielectric(scene, object)) {
            boxes.push_back(worldBounds(scene, object));
        }
    }
    const auto at = [&](const dvec3& point) {
        return std::ranges::any_of(boxes, [&](const Bounds& box) { return contains(box, point); }) ? around(point)
                                                                                                   : Media();
    };
    StartMedia start{.camera = at(scene.camera.position), .lights = {}};
    if (scene.environment) {
        start.lights.emplace_back();
    }
    for (const PointLight& light : scene.lights) {
        start.lights.push_back(at(light.position));
    }
    for (const SpotLight& light : scene.spots) {
        start.lights.push_back(at(light.position));
    }
    for (const DirectionalLight& light : scene.directionals) {
        start.lights.push_back(light.beam ? at(light.beam->center) : Media());
    }
    for (const Object& object : scene.objects) {
        if (object.emission != dvec3(0)) {
            start.lights.push_back(at(pointBefore(scene, object)));
        }
    }
    return start;
}

} // namespace

StartMedia startMedia(const Scene& scene, const World& world) {
    return collect(scene, [&](const dvec3& point) { return mediaAt(world, point); });
}

StartMedia startMedia(const Scene& scene) {
    std::optional<World> world;
    return collect(scene, [&](const dvec3& point) {
        if (!world) {
            world = prepareWorld(dielectricsOf(scene));
        }
        return mediaAt(*world, point);
    });
}

} // namespace hyalite::reference
