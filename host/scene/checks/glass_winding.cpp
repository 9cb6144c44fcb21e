// See glass_check.h: shells wound inward.
#include "reference/world.h"
#include "scene/checks/glass_check.h"
#include "scene/model/repeated_faces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>

namespace hyalite::checks {
namespace {

using glm::dvec3;

bool isGlass(const Scene& scene, const Object& object) {
    return object.material && boundsSolid(scene.materials[*object.material]);
}

// Whether a point is in a closed shell: its winding number from the solid angles of the triangles [Oosterom83].
bool isIn(const Mesh& mesh, const MeshShell& shell, const dvec3& point) {
    double angle = 0;
    std::size_t turned = 0;
    for (const std::uint32_t i : shell.triangles) {
        const glm::uvec3& t = mesh.triangles[i];
        const dvec3 a = dvec3(mesh.positions[t.x]) - point;
        const dvec3 b = dvec3(mesh.positions[t.y]) - point;
        const dvec3 c = dvec3(mesh.positions[t.z]) - point;
        const double la = glm::length(a);
        const double lb = glm::length(b);
        const double lc = glm::length(c);
        const bool isTurned = turned < shell.turned.size() && shell.turned[turned] == i;
        turned += isTurned ? 1 : 0;
        angle += (isTurned ? -2 : 2) *
                 std::atan2(glm::dot(a, glm::cross(b, c)),
                            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return std::abs(angle) > 2 * std::numbers::pi;
}

Bounds boundsOf(const Mesh& mesh, const MeshShell& shell) {
    Bounds box;
    for (const std::uint32_t i : shell.triangles) {
        for (int k = 0; k < 3; ++k) {
            box.add(mesh.positions[mesh.triangles[i][k]]);
        }
    }
    return box;
}

bool contains(const Bounds& box, const dvec3& point) {
    return glm::all(glm::lessThanEqual(box.low, point)) && glm::all(glm::lessThanEqual(point, box.high));
}

// What is wrong with an object's mesh.
struct Winding {
    std::vector<std::uint32_t> wrong; // ascending
    std::size_t shells = 0;           // with such triangles
    std::size_t whole = 0;            // of these, shells with no other triangles
};

class WindingCheck {
public:
    explicit WindingCheck(Scene& scene) : scene_(scene), shells_(scene) {}

    void run() {
        std::map<std::size_t, std::map<std::vector<std::uint32_t>, std::vector<std::size_t>>> users; // by mesh
        for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
            const auto* instance = std::get_if<MeshInstance>(&scene_.objects[i].shape);
            if (instance == nullptr) {
                continue;
            }
            std::vector<std::uint32_t> wrong;
            if (isGlass(scene_, scene_.objects[i])) {
                const Winding winding = look(i, *instance);
                if (!winding.wrong.empty()) {
                    report(scene_.objects[i], scene_.meshes[instance->mesh], winding);
                }
                wrong = winding.wrong;
            }
            users[instance->mesh][wrong].push_back(i);
        }
        for (const auto& [mesh, groups] : users) {
            turnFor(mesh, groups);
        }
    }

private:
    Winding look(std::size_t object, const MeshInstance& instance) {
        Winding found;
        for (const MeshShell& shell : shells_.of(instance.mesh)) {
            if (!shell.isSolid() || (shell.turned.empty() && shell.volume > 0)) {
                continue;
            }
            const bool isNested = isCavity(object, instance, shell);
            if (isNested && shell.turned.empty()) {
                continue;
            }
            std::vector<std::uint32_t> wrong = shell.turned; // as the first triangle is wound
            if ((shell.volume < 0) != isNested) {            // the first faces the wrong way
                wrong.clear();
                std::ranges::set_difference(shell.triangles, shell.turned, std::back_inserter(wrong));
            }
            ++found.shells;
            found.whole += wrong.size() == shell.triangles.size() ? 1 : 0;
            found.wrong.insert(found.wrong.end(), wrong.begin(), wrong.end());
        }
        std::ranges::sort(found.wrong);
        return found;
    }

    bool isCavity(std::size_t object, const MeshInstance& instance, const MeshShell& shell) {
        const Mesh& mesh = scene_.meshes[instance.mesh];
        const glm::uvec3& t = mesh.triangles[shell.triangles.front()];
        const dvec3 point =
            (dvec3(mesh.positions[t.x]) + dvec3(mesh.positions[t.y]) + dvec3(mesh.positions[t.z])) / 3.0;
        std::size_t around = 0;
        for (const MeshShell& other : shells_.of(instance.mesh)) {
            if (&other != &shell && other.isSolid() && contains(boundsOf(mesh, other), point) &&
                isIn(mesh, other, point)) {
                ++around;
            }
        }
        if (around % 2 == 1) {
            return true;
        }
        const dvec3 inWorld(instance.objectToWorld * glm::dvec4(point, 1));
        for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
            if (i != object && isGlass(scene_, scene_.objects[i])) {
                if (!world_) {
                    world_ = reference::prepareWorld(scene_);
                }
                if (reference::isInside(*world_, static_cast<std::uint32_t>(i), inWorld)) {
                    return true;
                }
            }
        }
        return false;
    }

    void report(const Object& object, const Mesh& mesh, const Winding& winding) {
        const std::uint32_t first = winding.wrong.front();
        const bool hasLine = !mesh.lines.empty();
        const SourceLocation where =
            hasLine ? SourceLocation{mesh.file, static_cast<int>(mesh.lines[first]), 1} : object.where;
        const std::string what =
            winding.whole == winding.shells
                ? "this closed mesh is glass (material '" + scene_.materials[*object.material].name +
                      "') but wound inward: its " + std::to_string(winding.wrong.size()) + " faces are turned"
                : std::to_string(winding.wrong.size()) + " faces of this closed mesh of glass (material '" +
                      scene_.materials[*object.material].name + "') are wound inward, " +
                      (hasLine ? "this one" : "triangle " + std::to_string(first + 1)) + " first: they are turned";
        warn(scene_, {WarningKind::TurnedFaces, where, what, "let all faces be counter-clockwise seen from outside"});
    }

    // Turns the mesh where all its users agree, else a copy for each group of objects.
    void turnFor(std::size_t mesh, const std::map<std::vector<std::uint32_t>, std::vector<std::size_t>>& groups) {
        const bool isLeaf = std::ranges::any_of(scene_.csgLeaves, [&](const Object& leaf) {
            const auto* instance = std::get_if<MeshInstance>(&leaf.shape);
            return instance != nullptr && instance->mesh == mesh;
        });
        const bool isShared = isLeaf || groups.size() > 1;
        for (const auto& [wrong, objects] : groups) {
            if (wrong.empty()) {
                continue;
            }
            std::size_t target = mesh;
            if (isShared) {
                target = scene_.meshes.size();
                scene_.meshes.push_back(Mesh(scene_.meshes[mesh]));
            }
            turn(scene_.meshes[target], wrong);
            for (const std::size_t object : objects) {
                std::get<MeshInstance>(scene_.objects[object].shape).mesh = target;
            }
        }
    }

    Scene& scene_;
    Shells shells_;
    std::optional<reference::World> world_;
};

} // namespace

bool boundsSolid(const Material& material) {
    const MaterialModel& model = material.model;
    return model.type == shared::kMaterialDielectric && model.thin == 0 &&
           (model.ior != 1 || model.absorption != dvec3(0) || model.priority != 0);
}

const std::vector<MeshShell>& Shells::of(std::size_t mesh) {
    const auto known = known_.find(mesh);
    return known != known_.end() ? known->second : known_.emplace(mesh, shellsOf(scene_.meshes[mesh])).first->second;
}

void turnInsideOutGlass(Scene& scene) {
    WindingCheck(scene).run();
}

void findBackToBackFaces(Scene& scene) {
    std::map<std::size_t, std::optional<FacePair>> pairs;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const auto* instance = std::get_if<MeshInstance>(&object.shape);
        if (instance == nullptr || (object.emission == dvec3(0) && !isGlass(scene, object))) {
            continue;
        }
        const Mesh& mesh = scene.meshes[instance->mesh];
        const auto [known, isNew] = pairs.try_emplace(instance->mesh);
        if (isNew) {
            known->second = findBackToBack(mesh);
        }
        if (const auto& pair = known->second) {
            const bool hasLine = !mesh.lines.empty();
            const SourceLocation where =
                hasLine ? SourceLocation{mesh.file, static_cast<int>(mesh.lines[pair->second]), 1} : object.where;
            const std::string faces =
                hasLine ? "this face lies back to back with that of line " + std::to_string(mesh.lines[pair->first])
                        : "triangles " + std::to_string(pair->first + 1) + " and " + std::to_string(pair->second + 1) +
                              " of the mesh lie back to back";
            warn(scene, {WarningKind::BackToBack, where, faces + ": rounding decides which of them a ray meets",
                         "leave a gap of at least 1e-5 of their distance from the origin"});
        }
    }
}

} // namespace hyalite::checks
