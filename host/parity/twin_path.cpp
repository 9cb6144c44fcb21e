#include "parity/twin_path.h"

#include "reference/integrators/path.h"
#include "reference/lib/sampling.h"
#include "reference/lights/receiver.h"
#include "scene/model/integrators.h"

#include <algorithm>

namespace hyalite::parity {

namespace {

// The vertex without the choice made there.
Vertex vertexOf(const Sides& sides, const PathKey& key, const PathState& state,
                const std::optional<reference::Hit>& hit, const std::optional<reference::Surface>& surface) {
    Vertex vertex;
    vertex.depth = state.depth;
    vertex.from = state.ray.origin;
    vertex.direction = state.ray.direction;
    if (key.isPhoton) {
        vertex.media = sides.numberOf(state.photon.media);
        vertex.weight = state.photon.power;
    } else {
        vertex.seed = state.camera.samplerSeed;
        vertex.media = sides.numberOf(state.camera.media);
        vertex.weight = state.camera.beta;
        vertex.pdfW = state.camera.pdfW;
    }
    vertex.medium = sides.mediumOf(vertex.media);
    if (hit) {
        setSurface(vertex, sides, *hit, *surface);
    }
    return vertex;
}

void stepCamera(const Sides& sides, std::uint32_t pass, const PathState& state, const reference::Hit& hit,
                const reference::Surface& surface, PathStep& step) {
    const reference::World& world = sides.world();
    const auto goOn = [&](const reference::NextRay& next) {
        step.next.push_back({.ray = next.ray, .camera = next.path, .photon = {}, .depth = state.depth + 1});
    };
    const reference::Shading shading = reference::shadeSurface(world, state.ray, hit, state.camera, state.depth, pass);
    for (const auto& next : shading.next) {
        if (next) {
            step.vertex.choice |= continuation(surface, next->ray.direction);
            goOn(*next);
        }
    }
    if (shading.visible && reference::receiverAt(*shading.visible).f != glm::dvec3(0)) {
        step.vertex.choice |= kDiffuse;
        if (world.cameraPaths.bouncesAtDiffuse) {
            if (const auto next = reference::bouncePath(world, *shading.visible, state.camera, pass)) {
                step.vertex.choice |= kBounced;
                goOn(*next);
            }
        }
    }
}

void stepPhoton(const Sides& sides, const reference::PhotonPass& pass, const PathState& state,
                const reference::Hit& hit, const reference::Surface& surface, PathStep& step) {
    const reference::PhotonScatter scatter =
        reference::scatterPhoton(sides.world(), state.ray, hit, state.photon, state.depth, pass);
    step.vertex.choice = scatter.stored ? kStored : 0;
    if (scatter.next) {
        step.vertex.choice |= continuation(surface, scatter.next->direction);
        step.next.push_back({.ray = *scatter.next, .camera = {}, .photon = scatter.path, .depth = state.depth + 1});
    }
}

void follow(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass, const PathState& state,
            std::vector<Vertex>& vertices) {
    const PathStep step = stepOf(sides, key, pass, state, reference::traceClosest(sides.world(), state.ray));
    vertices.push_back(step.vertex);
    for (const PathState& next : step.next) {
        // The last segment of the longest path belongs to the camera
        if (!key.isPhoton || next.depth < sides.world().render.maxDepth) {
            follow(sides, key, pass, next, vertices);
        }
    }
}

} // namespace

PathState stateBefore(const Sides& sides, const PathKey& key, const DeviceVertex& vertex) {
    PathState state{.ray = sides.toTwin(vertex.ray), .camera = {}, .photon = {}, .depth = vertex.depth};
    if (key.isPhoton) {
        state.photon = sides.toTwin(shared::PhotonPath{.power = glm::vec3(vertex.weight),
                                                       .photon = key.number,
                                                       .light = vertex.light,
                                                       .kind = vertex.photonKind,
                                                       .media = vertex.media});
    } else {
        state.camera = sides.toTwin(shared::CameraPath{.beta = glm::vec3(vertex.weight),
                                                       .pixel = key.number,
                                                       .samplerSeed = vertex.seed,
                                                       .media = vertex.media,
                                                       .pdfW = static_cast<float>(vertex.pdfW)});
    }
    return state;
}

PathStep stepOf(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass, const PathState& state,
                const std::optional<reference::Hit>& hit) {
    std::optional<reference::Surface> surface;
    if (hit) {
        surface = reference::evaluateSurface(sides.world(), state.ray, *hit);
    }
    PathStep step{.vertex = vertexOf(sides, key, state, hit, surface), .next = {}};
    if (hit && key.isPhoton) {
        stepPhoton(sides, pass, state, *hit, *surface, step);
    } else if (hit) {
        stepCamera(sides, key.sequence, state, *hit, *surface, step);
    }
    return step;
}

PathState firstState(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass, Nudge nudge) {
    const reference::World& world = sides.world();
    if (key.isPhoton) {
        const reference::Emission emission = reference::emitPhoton(world, key.number, pass, nudge.shift());
        return {.ray = emission.ray,
                .camera = {},
                .photon = {.power = emission.power,
                           .photon = key.number,
                           .light = emission.light,
                           .media = world.lights[emission.light].media}};
    }
    return {.ray = reference::generateCameraRay(world, key.number, key.sequence),
            .camera = reference::beginCameraPath(world, key.number, key.sequence),
            .photon = {}};
}

std::vector<Vertex> twinPath(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass) {
    std::vector<Vertex> vertices;
    const PathState first = firstState(sides, key, pass, Nudge(0));
    if (!key.isPhoton || first.depth < sides.world().render.maxDepth) {
        follow(sides, key, pass, first, vertices);
    }
    std::ranges::stable_sort(vertices, {}, &Vertex::depth);
    return vertices;
}

std::vector<RandomNumbers> randomNumbersAt(std::string_view integrator, const PathKey& path, const Vertex& vertex) {
    const shared::Sampler sampler = path.isPhoton ? shared::photonSampler(path.sequence, path.number)
                                                  : shared::pathSampler(vertex.seed, path.sequence);
    const std::uint32_t v = vertex.depth - 1;
    const auto pair = [&](std::uint32_t dimension) { return reference::sampleUnitSquare(sampler, dimension); };
    if (path.isPhoton) {
        return {{"roulette; lobe", pair(shared::photonScatter(v))}, {"direction", pair(shared::photonBounce(v))}};
    }
    std::vector<RandomNumbers> numbers{{"lobe or diffuse", pair(shared::cameraScatter(v))},
                                       {"direction", pair(shared::cameraBounce(v))},
                                       {"light", pair(shared::cameraLightChoice(v))},
                                       {"point on it", pair(shared::cameraLightPoint(v))}};
    if (integratorNamed(integrator).cameraPaths.bouncesAtDiffuse) {
        numbers.push_back({"diffuse bounce", pair(shared::pathBounce(v))});
        numbers.push_back({"roulette", pair(shared::pathRoulette(v))});
    }
    return numbers;
}

} // namespace hyalite::parity
