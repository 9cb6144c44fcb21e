#include "render/device_scene.h"

#include "render/material_table.h"
#include "render/mesh_tables.h"
#include "render/object_table.h"

#include <cmath>
#include <numbers>

namespace hyalite::render {

namespace {

using glm::dvec3;
using glm::vec3;

// Up to so many objects are tried one by one: eight measure 2.4 times as fast as their hierarchy.
constexpr std::size_t kFewObjects = 12;

shared::LightRecord lightRecord(const PointLight& light) {
    shared::LightRecord r{};
    r.type = shared::kLightPoint;
    r.position = light.position;
    r.emission = light.intensity;
    r.power = 4 * std::numbers::pi * light.intensity;
    return r;
}

shared::LightRecord lightRecord(const Quad& quad, const dvec3& radiance) {
    const dvec3 cross = glm::cross(quad.edge0, quad.edge1);
    const double area = glm::length(cross);
    shared::LightRecord r{};
    r.type = shared::kLightQuad;
    r.position = quad.corner;
    r.edge0 = quad.edge0;
    r.edge1 = quad.edge1;
    r.normal = cross / area;
    r.area = static_cast<float>(area);
    r.emission = radiance;
    r.power = std::numbers::pi * area * radiance;
    return r;
}

shared::LightRecord lightRecord(const Disk& disk, const dvec3& radiance) {
    shared::LightRecord r = lightRecord(Quad{disk.center, disk.axis0, disk.axis1}, radiance);
    r.type = shared::kLightDisk;
    const double area = std::numbers::pi * glm::length(glm::cross(disk.axis0, disk.axis1));
    r.area = static_cast<float>(area);
    r.power = std::numbers::pi * area * radiance;
    return r;
}

shared::LightRecord lightRecord(const Sphere& sphere, const dvec3& radiance) {
    const double area = 4 * std::numbers::pi * sphere.radius * sphere.radius;
    shared::LightRecord r{};
    r.type = shared::kLightSphere;
    r.position = sphere.center;
    r.edge0 = vec3(static_cast<float>(sphere.radius), 0, 0);
    r.area = static_cast<float>(area);
    r.emission = radiance;
    r.power = std::numbers::pi * area * radiance;
    return r;
}

shared::LightRecord lightRecord(const Object& object) {
    if (const auto* disk = std::get_if<Disk>(&object.shape)) {
        return lightRecord(*disk, object.emission);
    }
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        return lightRecord(*sphere, object.emission);
    }
    return lightRecord(std::get<Quad>(object.shape), object.emission);
}

bool emits(const Object& object) {
    return object.emission != dvec3(0);
}

} // namespace

shared::CameraRecord cameraRecord(const Camera& camera) {
    const dvec3 forward = glm::normalize(camera.lookAt - camera.position);
    const dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const dvec3 up = glm::cross(right, forward);
    const double tangent = std::tan(0.5 * camera.fov * std::numbers::pi / 180);
    const double aspect = static_cast<double>(camera.resolution.x) / static_cast<double>(camera.resolution.y);
    return {camera.position,    forward, right * (tangent * aspect), up * tangent, camera.resolution.x,
            camera.resolution.y};
}

std::vector<shared::LightRecord> lightRecords(const Scene& scene) {
    std::vector<shared::LightRecord> lights;
    for (const PointLight& light : scene.lights) {
        lights.push_back(lightRecord(light));
    }
    for (const Object& object : scene.objects) {
        if (emits(object)) {
            lights.push_back(lightRecord(object));
        }
    }
    const auto weight = [](const shared::LightRecord& light) {
        return static_cast<double>(light.power.x) + static_cast<double>(light.power.y) +
               static_cast<double>(light.power.z);
    };
    double total = 0;
    for (const auto& light : lights) {
        total += weight(light);
    }
    double sum = 0;
    for (auto& light : lights) {
        sum += weight(light);
        light.pmf = static_cast<float>(weight(light) / total);
        light.cdf = static_cast<float>(sum / total);
    }
    lights.back().cdf = 1;
    return lights;
}

DeviceScene uploadScene(const gpu::Context& context, gpu::TexelTables& tables, const Scene& scene) {
    MeshTables meshes = buildMeshTables(scene.meshes);
    ObjectTable objects =
        buildObjectTable(scene, meshes.roots, static_cast<std::uint32_t>(scene.lights.size()), meshes.nodes);
    const MaterialTable materials = buildMaterialTable(scene.materials);
    const std::vector<shared::LightRecord> lights = lightRecords(scene);

    DeviceScene device;
    device.camera = cameraRecord(scene.camera);
    device.rootNode = objects.rootNode;
    device.lightCount = static_cast<std::uint32_t>(lights.size());
    device.materials = {context, std::span<const shared::MaterialRecord>(materials.records), "materials"};
    device.hasRoughLobes = materials.hasRoughLobes();
    device.lights = {context, std::span<const shared::LightRecord>(lights), "lights"};
    device.instances = {context, std::span<const shared::InstanceRecord>(objects.instances), "instances"};
    device.normals = {context, std::span<const vec3>(meshes.normals), "normals"};
    device.nodes = {context, std::span<const glm::uvec4>(meshes.nodes), "BVH nodes"};
    device.objects = {context, std::span<const glm::vec4>(objects.texels), "objects"};
    device.triangles = {context, std::span<const glm::vec4>(meshes.triangles), "triangles"};
    tables.set(TABLE_NODES, device.nodes.buffer(), gpu::TexelFormat::Uint4);
    tables.set(TABLE_OBJECTS, device.objects.buffer(), gpu::TexelFormat::Float4);
    tables.set(TABLE_TRIANGLES, device.triangles.buffer(), gpu::TexelFormat::Float4);
    const bool areFew = scene.objects.size() <= kFewObjects;
    device.specialization["kShapeTypes"] = objects.shapeTypes;
    device.specialization["kFewObjects"] = areFew ? static_cast<std::uint32_t>(scene.objects.size()) : 0;
    device.specialization["kEndlessObjects"] = objects.endlessCount;
    device.specialization["kMaterialTypes"] = materials.types;
    device.objectOf = std::move(objects.objectOf);
    device.leafOf = std::move(objects.leafOf);
    device.triangleOf = std::move(meshes.fileOrder);
    return device;
}

} // namespace hyalite::render
