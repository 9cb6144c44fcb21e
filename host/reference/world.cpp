// Preparing the scene, and the two questions rays ask of it: what is nearest, and is the way free.
#include "reference/world.h"

#include "scene/bounds.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace hyalite::reference {

namespace {

// Sum of the lengths a point of the shape is computed from; see surfaceOffset.
double roundingScale(const Sphere& s) {
    return glm::length(s.center) + s.radius;
}
double roundingScale(const Quad& q) {
    return glm::length(q.corner) + glm::length(q.edge0) + glm::length(q.edge1);
}
double roundingScale(const Triangle& t) {
    return std::max({glm::length(t.corners[0]), glm::length(t.corners[1]), glm::length(t.corners[2])});
}

Triangle bakeTriangle(const Mesh& mesh, const glm::uvec3& indices, const glm::dmat4& objectToWorld) {
    const glm::dmat3 linear(objectToWorld);
    const glm::dmat3 normalMatrix = glm::transpose(glm::inverse(linear));
    Triangle triangle{};
    std::array<glm::dvec3, 3> local{};
    for (int i = 0; i < 3; ++i) {
        const auto corner = static_cast<std::size_t>(i);
        local[corner] = mesh.positions.at(indices[i]);
        triangle.corners[corner] = glm::dvec3(objectToWorld * glm::dvec4(local[corner], 1));
    }
    // From the mesh's own space, so that a mirroring transform keeps the front where the file has it.
    const glm::dvec3 area = glm::cross(local[1] - local[0], local[2] - local[0]);
    triangle.normal = area == glm::dvec3(0) ? area : glm::normalize(normalMatrix * area);
    triangle.normals.fill(triangle.normal);
    for (int i = 0; i < 3 && !mesh.normals.empty(); ++i) {
        // Not normalised: interpolating them is then the same as transforming what the mesh interpolates
        triangle.normals[static_cast<std::size_t>(i)] = normalMatrix * glm::dvec3(mesh.normals.at(indices[i]));
    }
    return triangle;
}

std::vector<Triangle> bakeMesh(const Scene& scene, const Object& object) {
    std::vector<Triangle> triangles;
    if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
        const Mesh& mesh = scene.meshes.at(instance->mesh);
        triangles.reserve(mesh.triangles.size());
        for (const glm::uvec3& indices : mesh.triangles) {
            triangles.push_back(bakeTriangle(mesh, indices, instance->objectToWorld));
        }
    }
    return triangles;
}

Box boundsOf(const World& world, const Primitive& primitive) {
    const Object& object = world.objects[primitive.object];
    Box box;
    double padding = 0; // corners of triangles are exact, the others are rounded here
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        box = {sphere->center - sphere->radius, sphere->center + sphere->radius};
        padding = surfaceOffset(roundingScale(*sphere));
    } else if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        for (const glm::dvec3& corner : {quad->corner, quad->corner + quad->edge0, quad->corner + quad->edge1,
                                         quad->corner + quad->edge0 + quad->edge1}) {
            box.include({corner, corner});
        }
        padding = surfaceOffset(roundingScale(*quad));
    } else {
        for (const glm::dvec3& corner : world.triangles[primitive.object][primitive.triangle].corners) {
            box.include({corner, corner});
        }
    }
    return {box.lower - padding, box.upper + padding};
}

std::optional<ShapeHit> intersectPrimitive(const World& world, const Primitive& primitive, const Ray& ray) {
    const Object& object = world.objects[primitive.object];
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        return intersectSphere(ray, *sphere);
    }
    if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        return intersectQuad(ray, *quad);
    }
    return intersectTriangle(ray, world.triangles[primitive.object][primitive.triangle]);
}

// What a shape alone knows about a point of it; normals still on the front.
void evaluateShape(const World& world, const Ray& ray, const Hit& hit, Surface& surface) {
    const Object& object = world.objects[hit.object];
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        surface.geometricNormal = glm::normalize(ray.origin + hit.t * ray.direction - sphere->center);
        surface.normal = surface.geometricNormal;
        surface.position = sphere->center + sphere->radius * surface.geometricNormal;
        surface.offset = surfaceOffset(roundingScale(*sphere));
    } else if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        surface.geometricNormal = glm::normalize(glm::cross(quad->edge0, quad->edge1));
        surface.normal = surface.geometricNormal;
        surface.position = quad->corner + hit.u * quad->edge0 + hit.v * quad->edge1;
        surface.offset = surfaceOffset(roundingScale(*quad));
    } else {
        const Triangle& triangle = world.triangles[hit.object][hit.primitive];
        const double w = 1 - hit.u - hit.v;
        const auto mix = [&](const std::array<glm::dvec3, 3>& at) { return w * at[0] + hit.u * at[1] + hit.v * at[2]; };
        surface.geometricNormal = triangle.normal;
        const glm::dvec3 interpolated = mix(triangle.normals);
        const double length = glm::length(interpolated);
        surface.normal = length > 0 ? interpolated / length : triangle.normal; // opposite normals may cancel
        surface.position = mix(triangle.corners);
        surface.offset = surfaceOffset(roundingScale(triangle));
    }
}

} // namespace

World prepareWorld(const Scene& scene) {
    World world{.camera = makeCameraFrame(scene.camera, scene.file),
                .render = scene.render,
                .initialRadius = initialRadius(scene),
                .materials = scene.materials,
                .objects = scene.objects,
                .triangles = {},
                .lights = makeLights(scene),
                .primitives = {},
                .bvh = {}};
    std::vector<Box> boxes;
    for (const Object& object : scene.objects) {
        world.triangles.push_back(bakeMesh(scene, object));
        const bool isMesh = std::holds_alternative<MeshInstance>(object.shape);
        const std::size_t count = isMesh ? world.triangles.back().size() : 1;
        for (std::size_t i = 0; i < count; ++i) {
            if (isMesh && world.triangles.back()[i].normal == glm::dvec3(0)) {
                continue; // no area: nothing can hit it
            }
            world.primitives.push_back({.object = static_cast<std::uint32_t>(world.triangles.size() - 1),
                                        .triangle = static_cast<std::uint32_t>(i)});
            boxes.push_back(boundsOf(world, world.primitives.back()));
        }
    }
    if (world.primitives.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw Error(ExitCode::BadInput, SourceLocation{.file = scene.file}, "more than 2^32 triangles and objects",
                    "use smaller meshes");
    }
    world.bvh = Bvh(boxes);
    return world;
}

std::optional<Hit> traceClosest(const World& world, const Ray& ray) {
    std::optional<Hit> nearest;
    Ray shrinking = ray;
    world.bvh.walk(shrinking, [&](std::uint32_t item) {
        const Primitive& primitive = world.primitives[item];
        const std::optional<ShapeHit> hit = intersectPrimitive(world, primitive, shrinking);
        if (hit && (!nearest || std::tuple(hit->t, primitive.object, primitive.triangle) <
                                    std::tuple(nearest->t, nearest->object, nearest->primitive))) {
            nearest = Hit{hit->t, primitive.object, primitive.triangle, hit->u, hit->v};
            shrinking.tMax = hit->t;
        }
        return true;
    });
    return nearest;
}

bool traceShadow(const World& world, const glm::dvec3& from, const glm::dvec3& to) {
    const double distance = glm::length(to - from);
    Ray ray{.origin = from, .direction = (to - from) / distance, .tMax = distance};
    bool visible = true;
    world.bvh.walk(ray, [&](std::uint32_t item) {
        visible = !intersectPrimitive(world, world.primitives[item], ray);
        return visible;
    });
    return visible;
}

Surface evaluateSurface(const World& world, const Ray& ray, const Hit& hit) {
    const Object& object = world.objects[hit.object];
    Surface surface{};
    evaluateShape(world, ray, hit, surface);
    surface.front = glm::dot(ray.direction, surface.geometricNormal) < 0;
    if (surface.front) {
        surface.emission = object.emission;
    } else {
        surface.geometricNormal = -surface.geometricNormal;
        surface.normal = -surface.normal;
    }
    if (object.material) {
        surface.material = &world.materials.at(*object.material);
    }
    return surface;
}

glm::dvec3 leave(const Surface& surface, const glm::dvec3& direction) {
    const double side = glm::dot(surface.geometricNormal, direction) >= 0 ? 1.0 : -1.0;
    return surface.position + side * surface.offset * surface.geometricNormal;
}

} // namespace hyalite::reference
