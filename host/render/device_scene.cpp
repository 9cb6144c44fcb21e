#include "render/device_scene.h"

#include "geometry/bvh.h"

#include "shaders/shared/limits.h"

#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace hyalite::render {

namespace {

using glm::dvec3;
using glm::vec3;
using glm::vec4;

// Few to a leaf: an object costs several box tests, a triangle about one. Estimates, not yet measured.
constexpr std::uint32_t kObjectsPerLeaf = 2;
constexpr std::uint32_t kTrianglesPerLeaf = 4;

// Up to so many objects are tried one by one: eight measure 2.4 times as fast as their hierarchy.
constexpr std::size_t kFewObjects = 12;

// Tables of all meshes, one behind the other.
struct MeshTables {
    std::vector<glm::uvec4> nodes;
    std::vector<vec4> triangles;
    std::vector<vec3> normals;
    std::vector<std::uint32_t> roots; // by mesh
};

void appendMesh(MeshTables& tables, const Mesh& mesh) {
    std::vector<Aabb> boxes(mesh.triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            boxes[i].add(mesh.positions[mesh.triangles[i][corner]]);
        }
    }
    Bvh bvh = buildBvh(boxes, kTrianglesPerLeaf);
    const auto firstNode = static_cast<std::uint32_t>(tables.nodes.size() / shared::kTexelsPerNode);
    const auto firstTriangle = static_cast<std::uint32_t>(tables.triangles.size() / shared::kTexelsPerTriangle);
    if (firstTriangle + mesh.triangles.size() > shared::kLeafFirstMask) {
        throw Error(ExitCode::BadInput, {mesh.file}, "more than 134 million triangles in the scene's meshes",
                    "use instances or coarser meshes");
    }
    relocate(bvh, firstNode, firstTriangle);
    tables.roots.push_back(firstNode);
    tables.nodes.insert(tables.nodes.end(), bvh.texels.begin(), bvh.texels.end());
    for (const std::uint32_t triangle : bvh.order) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.triangles[triangle][corner];
            tables.triangles.emplace_back(mesh.positions[vertex], 0.0F);
            tables.normals.push_back(mesh.normals.empty() ? vec3(0) : mesh.normals[vertex]);
        }
    }
}

// What the tables say of one object.
struct ObjectRecord {
    std::array<vec4, shared::kTexelsPerObject> texels{};
    shared::InstanceRecord instance{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    Aabb box;
};

vec4 header(std::uint32_t type, std::uint32_t material, std::uint32_t light, std::uint32_t root) {
    return {std::bit_cast<float>(type), std::bit_cast<float>(material), std::bit_cast<float>(light),
            std::bit_cast<float>(root)};
}

vec4 row(const glm::dmat4& m, int i) {
    return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

ObjectRecord record(const Sphere& sphere) {
    ObjectRecord r;
    const vec3 center = sphere.center;
    const auto radius = static_cast<float>(sphere.radius);
    r.texels[0] = vec4(center, radius);
    r.box.add(center - radius);
    r.box.add(center + radius);
    return r;
}

ObjectRecord record(const Quad& quad) {
    // Coordinates along the edges of a point p of the plane: the rows of the inverse of (edge0, edge1, normal)
    const dvec3 cross = glm::cross(quad.edge0, quad.edge1);
    const double area2 = glm::dot(cross, cross);
    const dvec3 u = glm::cross(quad.edge1, cross) / area2;
    const dvec3 v = glm::cross(cross, quad.edge0) / area2;
    const dvec3 normal = cross / std::sqrt(area2);
    ObjectRecord r;
    r.texels[0] = vec4(vec3(normal), static_cast<float>(glm::dot(normal, quad.corner)));
    r.texels[1] = vec4(vec3(u), static_cast<float>(-glm::dot(u, quad.corner)));
    r.texels[2] = vec4(vec3(v), static_cast<float>(-glm::dot(v, quad.corner)));
    for (const dvec3& corner :
         {quad.corner, quad.corner + quad.edge0, quad.corner + quad.edge1, quad.corner + quad.edge0 + quad.edge1}) {
        r.box.add(vec3(corner));
    }
    return r;
}

ObjectRecord record(const MeshInstance& instance, const Mesh& mesh) {
    const glm::dmat4 toObject = glm::inverse(instance.objectToWorld);
    ObjectRecord r;
    for (int i = 0; i < 3; ++i) {
        r.texels[static_cast<std::size_t>(i)] = row(toObject, i);
    }
    r.instance = {row(instance.objectToWorld, 0), row(instance.objectToWorld, 1), row(instance.objectToWorld, 2)};
    for (const vec3& p : mesh.positions) {
        r.box.add(vec3(instance.objectToWorld * glm::dvec4(p, 1.0)));
    }
    return r;
}

ObjectRecord record(const Scene& scene, const Object& object, std::uint32_t light, const MeshTables& meshes) {
    const std::uint32_t material = object.material ? static_cast<std::uint32_t>(*object.material) : shared::kNone;
    ObjectRecord r;
    std::uint32_t type = shared::kShapeMesh;
    std::uint32_t root = 0;
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        r = record(*sphere);
        type = shared::kShapeSphere;
    } else if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        r = record(*quad);
        type = shared::kShapeQuad;
    } else {
        const auto& instance = std::get<MeshInstance>(object.shape);
        r = record(instance, scene.meshes[instance.mesh]);
        root = meshes.roots[instance.mesh];
    }
    r.texels[3] = header(type, material, light, root);
    return r;
}

shared::MaterialRecord materialRecord(const Material& material) {
    if (const auto* diffuse = std::get_if<Diffuse>(&material.model)) {
        return {shared::kMaterialDiffuse, diffuse->albedo, 1};
    }
    if (const auto* mirror = std::get_if<Mirror>(&material.model)) {
        return {shared::kMaterialMirror, mirror->reflectance, 1};
    }
    const auto& dielectric = std::get<Dielectric>(material.model);
    return {shared::kMaterialDielectric, vec3(1), static_cast<float>(dielectric.ior)};
}

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
            lights.push_back(lightRecord(std::get<Quad>(object.shape), object.emission));
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
    MeshTables meshes;
    for (const Mesh& mesh : scene.meshes) {
        appendMesh(meshes, mesh);
    }

    std::vector<ObjectRecord> records;
    std::vector<Aabb> boxes;
    auto light = static_cast<std::uint32_t>(scene.lights.size());
    for (const Object& object : scene.objects) {
        records.push_back(record(scene, object, emits(object) ? light++ : shared::kNone, meshes));
        boxes.push_back(records.back().box);
    }
    Bvh bvh = buildBvh(boxes, kObjectsPerLeaf);

    DeviceScene device;
    device.camera = cameraRecord(scene.camera);
    device.rootNode = static_cast<std::uint32_t>(meshes.nodes.size() / shared::kTexelsPerNode);
    relocate(bvh, device.rootNode, 0);
    meshes.nodes.insert(meshes.nodes.end(), bvh.texels.begin(), bvh.texels.end());
    device.objectOrder = bvh.order;

    std::vector<vec4> texels;
    std::vector<shared::InstanceRecord> instances;
    for (const std::uint32_t object : bvh.order) {
        texels.insert(texels.end(), records[object].texels.begin(), records[object].texels.end());
        instances.push_back(records[object].instance);
    }
    std::vector<shared::MaterialRecord> materials;
    for (const Material& material : scene.materials) {
        materials.push_back(materialRecord(material));
    }
    const std::vector<shared::LightRecord> lights = lightRecords(scene);
    device.lightCount = static_cast<std::uint32_t>(lights.size());

    device.materials = {context, std::span<const shared::MaterialRecord>(materials), "materials"};
    device.lights = {context, std::span<const shared::LightRecord>(lights), "lights"};
    device.instances = {context, std::span<const shared::InstanceRecord>(instances), "instances"};
    device.normals = {context, std::span<const vec3>(meshes.normals), "normals"};
    device.nodes = {context, std::span<const glm::uvec4>(meshes.nodes), "BVH nodes"};
    device.objects = {context, std::span<const vec4>(texels), "objects"};
    device.triangles = {context, std::span<const vec4>(meshes.triangles), "triangles"};
    tables.set(TABLE_NODES, device.nodes.buffer(), gpu::TexelFormat::Uint4);
    tables.set(TABLE_OBJECTS, device.objects.buffer(), gpu::TexelFormat::Float4);
    tables.set(TABLE_TRIANGLES, device.triangles.buffer(), gpu::TexelFormat::Float4);
    device.specialization["kHasMeshes"] = scene.meshes.empty() ? 0 : 1;
    device.specialization["kFewObjects"] =
        scene.objects.size() <= kFewObjects ? static_cast<std::uint32_t>(scene.objects.size()) : 0;
    return device;
}

} // namespace hyalite::render
