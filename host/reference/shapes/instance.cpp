// See instance.h.
#include "reference/shapes/instance.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace hyalite::reference {

namespace {

struct Passage { // of the line through one triangle
    ShapeHit at;
    int turn = 0; // +1: enters the front, -1: leaves it
};

// All passages, ascending in t.
std::vector<Passage> passages(const Instance& instance, const Ray& world) {
    std::vector<Passage> result;
    Ray endless = instance.map.rayToObject({.origin = world.origin, .direction = world.direction});
    const ShearedLine line(endless);
    const auto visit = [&](std::uint32_t index) {
        if (const auto m = line.meetOnce(instance.tree->triangle(index))) {
            result.push_back({.at = {.t = m->t, .u = m->u, .v = m->v, .part = index}, .turn = m->fromFront ? 1 : -1});
        }
        return true;
    };
    instance.tree->bvh.walk(endless, visit, -kInfinite);
    std::sort(result.begin(), result.end(), [](const Passage& a, const Passage& b) {
        return std::tuple(a.at.t, a.at.part) < std::tuple(b.at.t, b.at.part);
    });
    return result;
}

} // namespace

MeshTree::MeshTree(Mesh source) : mesh(std::move(source)) {
    std::vector<Box> boxes(mesh.triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (const glm::dvec3& corner : triangle(i).corners) {
            boxes[i].include({corner, corner});
        }
    }
    bvh = Bvh(boxes);
}

Triangle MeshTree::triangle(std::size_t index) const {
    const glm::uvec3& corners = mesh.triangles[index];
    return {{mesh.positions[corners.x], mesh.positions[corners.y], mesh.positions[corners.z]}};
}

std::optional<ShapeHit> intersectInstance(const Ray& ray, const Instance& instance, Wanted wanted) {
    std::optional<ShapeHit> nearest;
    Ray shrinking = instance.map.rayToObject(ray);
    const ShearedLine line(shrinking);
    instance.tree->bvh.walk(shrinking, [&](std::uint32_t index) {
        const auto meeting = line.meetClosed(instance.tree->triangle(index));
        if (meeting && inRange(meeting->t, shrinking) &&
            (!nearest || std::tuple(meeting->t, index) < std::tuple(nearest->t, nearest->part))) {
            nearest = ShapeHit{.t = meeting->t, .u = meeting->u, .v = meeting->v, .part = index};
            shrinking.tMax = meeting->t;
        }
        return !nearest || wanted == Wanted::Nearest;
    });
    return nearest;
}

Crossings crossings(const Instance& instance, const Ray& line) {
    Crossings result;
    int winding = 0;
    for (const Passage& passage : passages(instance, line)) {
        const bool wasInside = winding != 0;
        winding += passage.turn;
        if ((winding != 0) != wasInside) {
            result.push_back({.at = passage.at, .entering = !wasInside});
        }
    }
    if (winding != 0) { // the mesh is not closed
        result.push_back({.at = {.t = kInfinite}, .entering = false});
    }
    return result;
}

bool isInside(const Instance& instance, const glm::dvec3& point) {
    constexpr glm::dvec3 kAnyDirection(0.48, 0.64, 0.6);
    int winding = 0;
    for (const Passage& passage : passages(instance, {.origin = point, .direction = kAnyDirection})) {
        winding += passage.at.t > 0 ? passage.turn : 0;
    }
    return winding != 0;
}

SurfacePoint surfaceAt(const Instance& instance, const Ray& ray, const ShapeHit& hit) {
    const Mesh& mesh = instance.tree->mesh;
    const std::array<glm::dvec3, 3> corners = instance.tree->triangle(hit.part).corners;
    const double w = 1 - hit.u - hit.v;
    SurfacePoint point{};
    if (!mesh.uvs.empty()) {
        const glm::uvec3& at = mesh.triangles[hit.part];
        point.uv =
            w * glm::dvec2(mesh.uvs[at.x]) + hit.u * glm::dvec2(mesh.uvs[at.y]) + hit.v * glm::dvec2(mesh.uvs[at.z]);
    }
    point.position = instance.map.pointToWorld(w * corners[0] + hit.u * corners[1] + hit.v * corners[2]);
    const glm::dvec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (area == glm::dvec3(0)) { // degenerate, hit only by rounding: it closes a gap between its neighbours
        point.geometricNormal = -ray.direction;
        point.normal = -ray.direction;
        point.offset = surfaceOffset(glm::length(point.position));
        return point;
    }
    point.geometricNormal = glm::normalize(instance.map.normalToWorld(area));
    point.normal = point.geometricNormal;
    if (!mesh.normals.empty()) {
        const glm::uvec3& at = mesh.triangles[hit.part];
        const glm::dvec3 interpolated = w * glm::dvec3(mesh.normals[at.x]) + hit.u * glm::dvec3(mesh.normals[at.y]) +
                                        hit.v * glm::dvec3(mesh.normals[at.z]);
        if (interpolated != glm::dvec3(0)) { // opposite normals may cancel
            point.normal = glm::normalize(instance.map.normalToWorld(interpolated));
        }
    }
    const double reach = std::max({glm::length(corners[0]), glm::length(corners[1]), glm::length(corners[2])});
    point.offset = surfaceOffset(roundingScale(instance.map, point.position, reach, area));
    return point;
}

} // namespace hyalite::reference
