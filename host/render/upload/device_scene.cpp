#include "render/upload/device_scene.h"

#include "geometry/media_needs.h"
#include "geometry/specular_targets.h"
#include "kinds/lights/light_table.h"
#include "kinds/materials/material_table.h"
#include "reference/media/touching_objects.h"
#include "render/upload/media_word.h"
#include "render/upload/mesh_tables.h"
#include "render/upload/object_table.h"
#include "render/upload/texture_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

namespace hyalite::render {

namespace {

using glm::dvec3;
using glm::vec3;

// Up to this many spheres and flat shapes are tested one by one: for eight this is 2.4 times as fast as a hierarchy.
constexpr std::size_t kFewObjects = 12;

// Is the object cheap to intersect? Meshes have their own hierarchies, and intersecting a solid costs more than testing
// its box.
bool isQuicklyTried(const Object& object) {
    return !std::holds_alternative<Quadric>(object.shape) && !std::holds_alternative<Torus>(object.shape) &&
           !std::holds_alternative<Csg>(object.shape);
}

// Rounds up to multiples of the stack's variables, so that scenes of similar depth share their kernels.
std::uint32_t roundedUp(std::uint32_t stackEntries) {
    return (stackEntries + shared::kStackTops - 1) / shared::kStackTops * shared::kStackTops;
}

// Bit kLight… for every type of light.
std::uint32_t typesOf(const std::vector<shared::LightRecord>& lights) {
    return std::accumulate(lights.begin(), lights.end(), 0U, [](std::uint32_t types, const shared::LightRecord& light) {
        return types | 1U << light.type;
    });
}

shared::CameraRecord cameraRecord(const Camera& camera, std::uint32_t media) {
    const dvec3 forward = glm::normalize(camera.lookAt - camera.position);
    const dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const dvec3 up = glm::cross(right, forward);
    const double tangent = std::tan(0.5 * camera.fov * std::numbers::pi / 180);
    const double aspect = static_cast<double>(camera.resolution.x) / static_cast<double>(camera.resolution.y);
    const double focus = camera.focusDistance > 0 ? camera.focusDistance : glm::length(camera.lookAt - camera.position);
    return {camera.position,
            forward,
            right * (tangent * aspect),
            up * tangent,
            camera.resolution.x,
            camera.resolution.y,
            static_cast<float>(0.5 * camera.aperture),
            static_cast<float>(focus),
            media};
}

} // namespace

shared::CameraRecord cameraRecord(const Scene& scene) {
    return cameraRecord(scene.camera, mediaWord(scene, reference::startMedia(scene).camera));
}

namespace {

// Copies a table to the device and frees the host's copy: there is no room for two copies of a large mesh.
template <class T>
gpu::Array<T> upload(const gpu::Context& context, std::vector<T>& table, const char* name) {
    gpu::Array<T> array(context, std::span<const T>(table), name);
    table = {};
    return array;
}

// Gives the objects their lists, one after another in the result, which they refer to by offsets in bytes.
std::vector<std::uint32_t> setNeighbors(const reference::Neighbors& touching, ObjectTable& objects) {
    std::vector<std::uint32_t> all;
    if (touching.empty()) {
        return all;
    }
    std::vector<std::uint32_t> deviceOf(touching.size());
    for (std::uint32_t i = 0; i < objects.objectOf.size(); ++i) {
        if (objects.leafOf[i] == shared::kNone) {
            deviceOf.at(objects.objectOf[i]) = i;
        }
    }
    for (std::uint32_t i = 0; i < objects.objectOf.size(); ++i) {
        if (objects.leafOf[i] == shared::kNone) {
            const std::vector<reference::Neighbor>& list = touching.at(objects.objectOf[i]);
            objects.instances[i].neighbors.address = all.size() * sizeof(std::uint32_t);
            objects.instances[i].neighborCount = static_cast<std::uint32_t>(list.size());
            for (const reference::Neighbor& neighbor : list) {
                all.push_back(deviceOf.at(neighbor.object));
                all.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(neighbor.extent)));
            }
        }
    }
    return all;
}

void uploadTextures(const gpu::Context& context, gpu::TexelTables& tables, const Scene& scene, const MeshTables& meshes,
                    DeviceScene& device) {
    device.specialization["kTextures"] = hasTextures(scene) ? 1 : 0;
    if (!hasTextures(scene)) {
        return;
    }
    const std::vector<glm::vec4> textures = textureTexels(scene.textures, scene.origin);
    const std::vector<glm::vec4> coordinates = coordinateTexels(scene.meshes, meshes);
    device.textures = {context, std::span<const glm::vec4>(textures), "textures"};
    device.textureCoordinates = {context, std::span<const glm::vec4>(coordinates), "texture coordinates"};
    tables.set(TABLE_TEXTURES, device.textures.buffer(), gpu::TexelFormat::Float4);
    tables.set(TABLE_TEXTURE_COORDINATES, device.textureCoordinates.buffer(), gpu::TexelFormat::Float4);
}

} // namespace

DeviceScene uploadScene(const gpu::Context& context, gpu::TexelTables& tables, const Scene& scene) {
    MeshTables meshes = buildMeshTables(scene.meshes);
    kinds::LightTable lights = kinds::buildLightTable(scene);
    ObjectTable objects = buildObjectTable(scene, meshes.roots, lights.firstEmitter, meshes.geometry);
    const kinds::MaterialTable materials = kinds::buildMaterialTable(scene.materials);

    std::vector<shared::TargetRecord> targets;
    for (const BoundingSphere& sphere : specularTargets(scene)) {
        const bool endless = std::isinf(sphere.radius);
        targets.push_back({sphere.center, endless ? 3e38F : static_cast<float>(sphere.radius)});
    }

    DeviceScene device;
    device.targets = {context, std::span<const shared::TargetRecord>(targets), "targets"};
    device.targetCount = static_cast<std::uint32_t>(targets.size());
    const reference::StartMedia start = reference::startMedia(scene);
    device.camera = cameraRecord(scene.camera, mediaWord(scene, start.camera));
    for (std::size_t i = 0; i < lights.lights.size(); ++i) {
        lights.lights[i].media = mediaWord(scene, start.lights.at(i));
    }
    device.rootNode = objects.rootNode;
    device.lightCount = static_cast<std::uint32_t>(lights.lights.size());
    device.materials = {context, std::span<const shared::MaterialRecord>(materials.records), "materials"};
    device.hasRoughLobes = materials.hasRoughLobes();
    device.lightTriangles = {context, std::span<const shared::LightTriangle>(lights.triangles), "emitting triangles"};
    device.lightTexels = {context, std::span<const vec3>(lights.texels), "environment"};
    device.lightCdfs = {context, std::span<const float>(lights.cdfs), "parts of lights"};
    device.lightNodes = {context, std::span<const shared::LightNode>(lights.nodes), "hierarchy of lights"};
    const shared::LightHierarchy hierarchy{device.lightNodes, device.lightCount, lights.farCount};
    device.lightHierarchy = {context, std::span(&hierarchy, 1), "head of the hierarchy of lights"};
    kinds::setAddresses(lights.lights, device.lightTriangles, device.lightTexels, device.lightCdfs,
                        device.lightHierarchy);
    device.lights = {context, std::span<const shared::LightRecord>(lights.lights), "lights"};
    const std::vector<std::uint32_t> neighbors = setNeighbors(reference::touchingObjects(scene), objects);
    device.neighbors = {context, std::span<const std::uint32_t>(neighbors), "touching objects"};
    for (shared::InstanceRecord& instance : objects.instances) {
        instance.neighbors.address += shared::UintArray(device.neighbors).address;
    }
    device.instances = {context, std::span<const shared::InstanceRecord>(objects.instances), "instances"};
    device.normals = upload(context, meshes.normals, "normals");
    device.geometry = upload(context, meshes.geometry, "geometry");
    device.objects = {context, std::span<const glm::vec4>(objects.texels), "objects"};
    tables.set(TABLE_GEOMETRY, device.geometry.buffer(), gpu::TexelFormat::Uint4);
    tables.set(TABLE_OBJECTS, device.objects.buffer(), gpu::TexelFormat::Float4);
    uploadTextures(context, tables, scene, meshes, device);
    const bool areFew =
        scene.objects.size() <= kFewObjects && std::all_of(scene.objects.begin(), scene.objects.end(), isQuicklyTried);
    device.specialization["kShapeTypes"] = objects.shapeTypes;
    device.specialization["kFewObjects"] = areFew ? static_cast<std::uint32_t>(scene.objects.size()) : 0;
    device.specialization["kEndlessObjects"] = objects.endlessCount;
    device.specialization["kStackEntries"] = roundedUp(objects.stackEntries + meshes.stackEntries);
    device.specialization["kCsgLeaves"] = std::max(objects.mostLeaves, 1U);
    const bool hasDielectrics = (materials.types & 1U << shared::kMaterialDielectric) != 0;
    device.specialization["kMediumBits"] = // scenes without share their kernels
        hasDielectrics ? shared::mediumBits(static_cast<std::uint32_t>(scene.materials.size())) : 8;
    const std::uint32_t touching = shared::kMediaTouch | shared::kMediaIndices | shared::kMediaShadows;
    device.specialization["kMediaNeeds"] = mediaNeeds(scene) | (neighbors.empty() ? 0 : touching);
    device.specialization["kLightTypes"] = typesOf(lights.lights);
    device.specialization["kMaterialTypes"] = materials.types;
    device.specialization["kLightCount"] = std::min(device.lightCount, shared::kFewLights + 1);
    device.specialization["kLightsSought"] = device.lightCount <= shared::kMostLightsSought ? device.lightCount : 0;
    device.objectOf = std::move(objects.objectOf);
    device.leafOf = std::move(objects.leafOf);
    device.triangleOf = std::move(meshes.fileOrder);
    return device;
}

} // namespace hyalite::render
