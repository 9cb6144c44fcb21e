// See light_check.h. A light is reached if one of its paths meets a surface that is in plain view of the camera or of a
// surface on a camera path, or if a camera path meets the light itself.
#include "scene/checks/light_check.h"

#include "reference/bsdf/bsdf.h"
#include "scene/checks/probe_path.h"
#include "scene/model/integrators.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>

namespace hyalite::checks {
namespace {

using glm::dvec3;

constexpr int kMostSurfaces = 16; // of a path
constexpr int kCameraPaths = 512; // tried
constexpr std::size_t kViews = 4; // surfaces of camera paths that a light's surface is connected to

struct LightPlace {
    SourceLocation where;
    std::string name;
    bool hasSurface; // a path can meet it
};

// The lights in the order of the reference's.
std::vector<LightPlace> placesOf(const Scene& scene) {
    std::vector<LightPlace> places;
    if (scene.environment) {
        places.push_back({scene.environment->where, "environment", true});
    }
    for (const PointLight& light : scene.lights) {
        places.push_back({light.where, "point light", false});
    }
    for (const SpotLight& light : scene.spots) {
        places.push_back({light.where, "spot light", false});
    }
    for (const DirectionalLight& light : scene.directionals) {
        places.push_back({light.where, "directional light", false});
    }
    for (const Object& object : scene.objects) {
        if (object.emission != dvec3(0)) {
            places.push_back({object.where, "emitting object", true});
        }
    }
    return places;
}

std::string placeText(const SourceLocation& where) {
    return "line " + std::to_string(where.line) + " column " + std::to_string(where.column);
}

bool canBeSeen(const ProbeVertex& vertex) {
    return (vertex.flags & (shared::kBsdfDiffuse | shared::kBsdfGlossy)) != 0;
}

class LightCheck {
public:
    explicit LightCheck(const Scene& scene)
        : scene_(scene), world_(reference::prepareWorld(scene)), places_(placesOf(scene)) {
        const IntegratorRow& row = integratorNamed(scene.render.integrator);
        missesAllCaustics_ = row.cameraPaths.followsAllWays;
        missesDeltaCaustics_ = row.cameraPaths.bouncesAtDiffuse;
        lookAround();
    }

    std::vector<Warning> run() {
        int left = kPathsInAll;
        for (std::size_t i = 0; i < std::min(places_.size(), world_.lights.size()) && left > 0; ++i) {
            left -= tryLight(i);
        }
        return std::move(warnings_);
    }

private:
    // Camera paths: the surfaces that they meet, and the lights.
    void lookAround() {
        const reference::CameraFrame& camera = world_.camera;
        for (int i = 0; i < kCameraPaths; ++i) {
            const glm::dvec2 at = 2.0 * dice_.pair() - 1.0;
            const dvec3 direction = glm::normalize(camera.forward + at.x * camera.right + at.y * camera.up);
            const ProbePath path =
                follow(world_, {.origin = camera.position, .direction = direction}, kMostSurfaces, dice_);
            for (const ProbeVertex& vertex : path.vertices) {
                if (canBeSeen(vertex)) {
                    views_.push_back(vertex);
                }
                if (vertex.isLit) {
                    met_.push_back(vertex.object);
                }
            }
            seesEnvironment_ = seesEnvironment_ || path.escapes;
        }
        std::ranges::sort(met_);
    }

    [[nodiscard]] bool isMet(std::size_t light) const {
        if (scene_.environment && light == 0) {
            return seesEnvironment_;
        }
        const auto& object = world_.lights[light].object;
        return object && std::ranges::binary_search(met_, *object);
    }

    // Whether what is at the vertex can be seen by the camera, or from a surface that a camera path meets.
    bool isInView(const ProbeVertex& vertex) {
        const auto faces = [](const ProbeVertex& one, const dvec3& other) {
            return glm::dot(other - one.position, one.normal) > 0;
        };
        const dvec3& eye = world_.camera.position;
        const dvec3 toVertex = vertex.position - eye;
        if (faces(vertex, eye) && glm::dot(toVertex, world_.camera.forward) > 0 &&
            reference::traceShadow(world_, eye, vertex.position)) {
            return true;
        }
        for (std::size_t i = 0; i < kViews && !views_.empty(); ++i) {
            const ProbeVertex& view = views_[dice_.index(views_.size())];
            if (faces(vertex, view.position) && faces(view, vertex.position) &&
                reference::traceShadow(world_, view.position, vertex.position)) {
                return true;
            }
        }
        return false;
    }

    // Returns the number of paths.
    int tryLight(std::size_t light) {
        const bool wantsCaustic = missesAllCaustics_ || (missesDeltaCaustics_ && !places_[light].hasSurface);
        bool isReached = isMet(light);
        bool isSearching = wantsCaustic && hasSpecular() && !scene_.accepted.contains(WarningKind::UnseenCaustic);
        bool meetsAnything = false;
        int paths = 0;
        for (; paths < kPathsFromLight && (!isReached || isSearching); ++paths) {
            const reference::LightRay start = reference::emitFrom(world_.lights[light], dice_.pair(), dice_.pair());
            const ProbePath path = follow(world_, {.origin = reference::startOf(start), .direction = start.direction},
                                          kMostSurfaces, dice_);
            meetsAnything = meetsAnything || !path.vertices.empty();
            for (const ProbeVertex& vertex : path.vertices) {
                isReached = isReached || (canBeSeen(vertex) && isInView(vertex));
            }
            if (isSearching && reportCaustic(light, path)) {
                isSearching = false;
            }
        }
        if (!isReached) {
            reportUnseen(light, meetsAnything);
        }
        return paths;
    }

    [[nodiscard]] bool hasSpecular() const {
        return std::ranges::any_of(world_.materials, [](const Material& one) { return isSpecular(one); });
    }

    // Reports a path that leads over mirrors and glass to a diffuse surface.
    bool reportCaustic(std::size_t light, const ProbePath& path) {
        const auto end = std::ranges::find_if(path.vertices, [](const ProbeVertex& vertex) {
            return vertex.isAfterSpecular && (vertex.flags & shared::kBsdfDiffuse) != 0;
        });
        if (end == path.vertices.end()) {
            return false;
        }
        const auto bend = std::ranges::find_if(path.vertices, [](const ProbeVertex& vertex) {
            return vertex.material != nullptr && isSpecular(*vertex.material);
        });
        const bool isGlass = bend->material->model.type == shared::kMaterialDielectric;
        add({WarningKind::UnseenCaustic, places_[light].where,
             "integrator " + scene_.render.integrator + " does not show the light that this " + places_[light].name +
                 " sends over the " + (isGlass ? "glass" : "mirror") + " '" + bend->material->name +
                 "' (the object at " + placeText(scene_.objects[bend->object].where) + ") to diffuse surfaces",
             "ppm shows caustics"});
        return true;
    }

    void reportUnseen(std::size_t light, bool meetsAnything) {
        const std::string tried = "none of " + std::to_string(kPathsFromLight);
        add({WarningKind::UnseenLight, places_[light].where,
             meetsAnything ? tried + " paths from this " + places_[light].name + " reaches what the camera sees"
                           : tried + " rays from this " + places_[light].name + " meets a surface",
             meetsAnything ? "is it inside a solid, behind a wall, or turned away?" : "turn it to the scene"});
    }

    void add(Warning warning) {
        if (!scene_.accepted.contains(warning.kind)) {
            warnings_.push_back(std::move(warning));
        }
    }

    const Scene& scene_;
    reference::World world_;
    std::vector<LightPlace> places_;
    Dice dice_;
    std::vector<ProbeVertex> views_;
    std::vector<std::uint32_t> met_; // emitting objects on camera paths, sorted
    std::vector<Warning> warnings_;
    bool seesEnvironment_ = false;
    bool missesAllCaustics_ = false;
    bool missesDeltaCaustics_ = false; // those of lights that no path can meet
};

std::size_t sizeOf(const Scene& scene) {
    return std::accumulate(scene.meshes.begin(), scene.meshes.end(), scene.objects.size(),
                           [](std::size_t sum, const Mesh& mesh) { return sum + mesh.triangles.size(); });
}

} // namespace

std::vector<Warning> lightWarnings(const Scene& scene) {
    return sizeOf(scene) > kLargestProbed ? std::vector<Warning>() : LightCheck(scene).run();
}

} // namespace hyalite::checks
