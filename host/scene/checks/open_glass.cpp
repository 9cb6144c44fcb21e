// See glass_check.h: dielectric surfaces that bound nothing, found with rays of the reference.
#include "reference/lib/sampling.h"
#include "reference/world.h"
#include "scene/checks/dice.h"
#include "scene/checks/glass_check.h"
#include "scene/model/bounds.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace hyalite::checks {
namespace {

using glm::dvec3;

constexpr int kMostSearches = 256; // objects that are searched
constexpr int kLines = 256;        // lines through the object's bounds
constexpr int kStarts = 64;        // places behind its surface
constexpr int kRaysFromPlace = 12; // half of them aimed at open edges, if there are any

bool isOpenShape(const Shape& shape) {
    if (const auto* quadric = std::get_if<Quadric>(&shape)) {
        const Bounds all = Bounds::everything();
        return !quadric->capped && (quadric->clip.low != all.low || quadric->clip.high != all.high);
    }
    return std::holds_alternative<Quad>(shape) || std::holds_alternative<Disk>(shape);
}

// Places just outside open edges [m].
std::vector<dvec3> besideOpenEdges(const Mesh& mesh, const std::vector<MeshShell>& shells, const glm::dmat4& toWorld) {
    constexpr std::size_t kMost = 512;
    std::vector<dvec3> places;
    for (const MeshShell& shell : shells) {
        for (std::size_t i = 0; i < shell.open.size() && places.size() < kMost; ++i) {
            const glm::uvec3& t = mesh.triangles[shell.open[i]];
            const std::array<dvec3, 3> corners{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
            const dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
            for (std::size_t k = 0; k < 3; ++k) {
                const dvec3 onEdge = (corners.at(k) + corners.at((k + 1) % 3)) / 2.0;
                places.emplace_back(toWorld * glm::dvec4(onEdge + 0.2 * (onEdge - middle), 1));
            }
        }
    }
    return places;
}

class LeakSearch {
public:
    LeakSearch(const Scene& scene, const reference::World& world) : scene_(scene), world_(world) {}

    // Whether a ray that starts behind a surface of the object gets out: to infinity, or to the front of a surface of
    // the same material.
    bool leaks(std::uint32_t object, const std::vector<dvec3>& targets) {
        const Bounds box = worldBounds(scene_, scene_.objects[object]);
        const double size = glm::length(box.high - box.low);
        int starts = 0;
        for (int line = 0; line < kLines && starts < kStarts; ++line) {
            const dvec3 along = reference::uniformSphere(dice_.pair());
            const dvec3 share{dice_.next(), dice_.next(), dice_.next()};
            const dvec3 through = box.low + share * (box.high - box.low);
            reference::Ray ray{.origin = through - size * along, .direction = along};
            for (int passed = 0; passed < 16; ++passed) {
                const auto hit = reference::traceClosest(world_, ray);
                if (!hit) {
                    break;
                }
                const reference::Surface surface = reference::evaluateSurface(world_, ray, *hit);
                if (hit->object == object) {
                    ++starts;
                    const dvec3 inward = surface.front ? -surface.geometricNormal : surface.geometricNormal;
                    if (leaksFrom(surface, inward, object, targets)) {
                        return true;
                    }
                }
                ray.origin = reference::leave(surface, along);
            }
        }
        return false;
    }

private:
    bool leaksFrom(const reference::Surface& surface, const dvec3& inward, std::uint32_t object,
                   const std::vector<dvec3>& targets) {
        for (int i = 0; i < kRaysFromPlace; ++i) {
            const bool isAimed = i % 2 == 1 && !targets.empty();
            reference::Ray ray{.origin = surface.position + surface.offset * inward, .direction = inward};
            ray.direction = isAimed ? glm::normalize(targets[dice_.index(targets.size())] - ray.origin)
                                    : reference::cosineHemisphere(dice_.pair(), inward);
            if (!(glm::dot(ray.direction, inward) > 0)) {
                continue;
            }
            const auto hit = reference::traceClosest(world_, ray);
            if (!hit) {
                return true;
            }
            const reference::Surface there = reference::evaluateSurface(world_, ray, *hit);
            if (there.front && there.material == &world_.materials[*scene_.objects[object].material]) {
                return true;
            }
        }
        return false;
    }

    const Scene& scene_;
    const reference::World& world_;
    Dice dice_;
};

void report(Scene& scene, const Object& object, const std::vector<MeshShell>* shells) {
    const std::string name = " of glass (material '" + scene.materials[*object.material].name + "') ";
    std::string what;
    SourceLocation where = object.where;
    if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
        const Mesh& mesh = scene.meshes[instance->mesh];
        std::optional<std::uint32_t> edge; // the first triangle beside an open edge
        for (const MeshShell& shell : *shells) {
            if (!shell.open.empty() && (!edge || shell.open.front() < *edge)) {
                edge = shell.open.front();
            }
        }
        if (edge && !mesh.lines.empty()) {
            where = {mesh.file, static_cast<int>(mesh.lines[*edge]), 1};
        }
        what = "this mesh" + name +
               (!edge                ? "encloses nothing"
                : mesh.lines.empty() ? "is open beside its triangle " + std::to_string(*edge + 1)
                                     : "is open beside this face");
    } else {
        const bool isFlat = !std::holds_alternative<Quadric>(object.shape);
        what = std::string(isFlat ? "this sheet" : "this open shape") + name + "encloses nothing";
    }
    warn(scene, {WarningKind::OpenGlass, where, what + ": light that enters it is inside for good",
                 "close it to a solid, or give the material thin: true"});
}

} // namespace

void findOpenGlass(Scene& scene) {
    Shells shells(scene);
    std::optional<reference::World> world;
    std::optional<LeakSearch> search;
    int searches = 0;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        if (!object.material || !boundsSolid(scene.materials[*object.material])) {
            continue;
        }
        const auto* instance = std::get_if<MeshInstance>(&object.shape);
        const std::vector<MeshShell>* ofMesh = instance != nullptr ? &shells.of(instance->mesh) : nullptr;
        const bool isOpenMesh = ofMesh != nullptr && !std::ranges::all_of(*ofMesh, &MeshShell::isSolid);
        if ((!isOpenMesh && !isOpenShape(object.shape)) || ++searches > kMostSearches) {
            continue;
        }
        if (!world) {
            world = reference::prepareWorld(scene);
            search.emplace(scene, *world);
        }
        const std::vector<dvec3> targets =
            instance != nullptr ? besideOpenEdges(scene.meshes[instance->mesh], *ofMesh, instance->objectToWorld)
                                : std::vector<dvec3>();
        if (search->leaks(static_cast<std::uint32_t>(i), targets)) {
            report(scene, object, ofMesh);
        }
    }
}

} // namespace hyalite::checks
