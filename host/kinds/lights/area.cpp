// Light from the surface of an object: shaders/lights/area.glsl, host/reference/lights/area.cpp.
#include "kinds/lights/area.h"

#include "kinds/lights/light_kinds.h"
#include "scene/model/bounds.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace hyalite::kinds {
namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr KeyDoc kEmission{
    .name = "emission",
    .type = KeyType::Color,
    .range = kRadiance,
    .defaultText = "0",
    .text = "radiance of the front; only quads, disks, meshes (including the teapot) and spheres (unless a "
            "transform makes them ellipsoids)"};
constexpr std::array kKeys{kEmission, kPhotonShare};

shared::LightRecord surface(std::uint32_t type, double area, const dvec3& radiance) {
    shared::LightRecord r{};
    r.type = type;
    r.area = static_cast<float>(area);
    r.emission = radiance;
    r.power = pi * area * radiance;
    return r;
}

shared::LightRecord flat(std::uint32_t type, const dvec3& origin, const dvec3& edge0, const dvec3& edge1, double area,
                         const dvec3& radiance) {
    shared::LightRecord r = surface(type, area, radiance);
    r.position = origin;
    r.edge0 = edge0;
    r.edge1 = edge1;
    r.normal = glm::normalize(glm::cross(edge0, edge1));
    return r;
}

shared::LightRecord meshRecord(const Scene& scene, const MeshInstance& instance, const Object& object,
                               LightTable& table) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const glm::dmat3 linear(instance.objectToWorld);
    const dvec3 translation(instance.objectToWorld[3]);
    const bool mirrored = glm::determinant(linear) < 0;
    const std::size_t first = table.triangles.size();
    const std::size_t firstCdf = table.cdfs.size();
    std::vector<double> areas;
    double reach = 0; // largest sum of the terms of a coordinate
    for (const glm::uvec3& triangle : mesh.triangles) {
        const dvec3 a(mesh.positions[triangle.x]);
        dvec3 edge0 = linear * (dvec3(mesh.positions[triangle.y]) - a);
        dvec3 edge1 = linear * (dvec3(mesh.positions[triangle.z]) - a);
        if (mirrored) {
            std::swap(edge0, edge1);
        }
        const dvec3 cross = glm::cross(edge0, edge1);
        const double twiceArea = glm::length(cross);
        if (!(twiceArea > 0)) {
            continue;
        }
        table.triangles.push_back({linear * a + translation, edge0, edge1, cross / twiceArea});
        areas.push_back(twiceArea / 2);
        for (int corner = 0; corner < 3; ++corner) {
            const dvec3 p = glm::abs(dvec3(mesh.positions[triangle[corner]]));
            const dvec3 terms = glm::abs(linear[0]) * p.x + glm::abs(linear[1]) * p.y + glm::abs(linear[2]) * p.z +
                                glm::abs(translation);
            reach = std::max({reach, terms.x, terms.y, terms.z});
        }
    }
    if (areas.empty() || table.triangles.size() > shared::kLeafFirstMask) {
        throw Error(ExitCode::BadInput, object.where,
                    areas.empty() ? "this mesh has no area to emit light from"
                                  : "more than 134 million triangles in the scene's emitting meshes");
    }
    shared::LightRecord r = surface(shared::kLightMesh, appendCdf(table.cdfs, areas), object.emission);
    r.columns = static_cast<std::uint32_t>(areas.size());
    r.error = static_cast<float>(0x1p-19 * reach); // as for triangle hits, see shapes/surface.glsl
    r.triangles.address = first * sizeof(shared::LightTriangle);
    r.cdfs.address = firstCdf * sizeof(float);
    return r;
}

shared::LightRecord record(const Scene& scene, const Object& object, LightTable& table) {
    if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        const dvec3 cross = glm::cross(quad->edge0, quad->edge1);
        return flat(shared::kLightQuad, quad->corner, quad->edge0, quad->edge1, glm::length(cross), object.emission);
    }
    if (const auto* disk = std::get_if<Disk>(&object.shape)) {
        const dvec3 cross = glm::cross(disk->axis0, disk->axis1);
        return flat(shared::kLightDisk, disk->center, disk->axis0, disk->axis1, pi * glm::length(cross),
                    object.emission);
    }
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        shared::LightRecord r =
            surface(shared::kLightSphere, 4 * pi * sphere->radius * sphere->radius, object.emission);
        r.position = sphere->center;
        r.radius = static_cast<float>(sphere->radius);
        return r;
    }
    if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
        return meshRecord(scene, *instance, object, table);
    }
    throw Error(ExitCode::BadInput, object.where, "only quads, disks, spheres and meshes emit light",
                "use one of these shapes");
}

void addRecords(const Scene& scene, LightTable& table) {
    table.firstEmitter = static_cast<std::uint32_t>(table.lights.size());
    for (const Object& object : scene.objects) {
        if (object.emission != dvec3(0)) {
            table.add(record(scene, object, table), object.photonShare);
        }
    }
}

} // namespace

Emission readEmission(Reader& reader) {
    Emission emission;
    emission.where = reader.find(kEmission.name);
    readKey(reader, kEmission, emission.radiance);
    readKey(reader, kPhotonShare, emission.photonShare);
    return emission;
}

void checkEmission(const Value& emission, const Shape& shape, const Scene& scene) {
    if (const auto* instance = std::get_if<MeshInstance>(&shape)) {
        if (!(worldArea(scene.meshes[instance->mesh], instance->objectToWorld) > 0)) {
            emission.fail("this mesh has no area to emit light from");
        }
    } else if (!std::holds_alternative<Quad>(shape) && !std::holds_alternative<Disk>(shape) &&
               !std::holds_alternative<Sphere>(shape)) {
        emission.fail("only quads, disks, spheres and meshes can emit light", "use one of these, or a point light");
    }
}

constinit const LightKind kAreaLight{
    .doc = {.keys = kKeys}, .addRecords = addRecords, .reference = referenceLight<reference::AreaLight>()};

} // namespace hyalite::kinds
