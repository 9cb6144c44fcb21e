#include "parity/path_step.h"

#include "reference/integrators/path.h"

namespace hyalite::parity {

namespace {

std::uint32_t wayOn(const reference::Surface& surface, const glm::dvec3& direction) {
    return glm::dot(direction, surface.geometricNormal) < 0 ? kTransmitted : kReflected;
}

// The vertex without what is chosen there.
Vertex vertexOf(const Sides& sides, const PathKey& key, const PathState& state,
                const std::optional<reference::Hit>& hit, const std::optional<reference::Surface>& surface) {
    Vertex vertex;
    vertex.depth = state.depth;
    vertex.from = state.ray.origin;
    vertex.direction = state.ray.direction;
    if (key.isPhoton) {
        vertex.medium = sides.numberOf(state.photon.medium);
        vertex.weight = state.photon.power;
    } else {
        vertex.seed = state.camera.samplerSeed;
        vertex.medium = sides.numberOf(state.camera.medium);
        vertex.weight = state.camera.beta;
        vertex.pdfW = state.camera.pdfW;
    }
    if (hit) {
        vertex.position = surface->position;
        vertex.normal = surface->normal;
        vertex.front = surface->front;
        vertex.object = hit->object;
        vertex.primitive = hit->primitive;
        vertex.material = sides.numberOf(surface->material);
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
            step.vertex.choice |= wayOn(surface, next->ray.direction);
            goOn(*next);
        }
    }
    if (shading.visible && shading.visible->f != glm::dvec3(0)) {
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
        step.vertex.choice |= wayOn(surface, scatter.next->direction);
        step.next.push_back({.ray = *scatter.next, .camera = {}, .photon = scatter.path, .depth = state.depth + 1});
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
                                                       .medium = vertex.medium});
    } else {
        state.camera = sides.toTwin(shared::CameraPath{.beta = glm::vec3(vertex.weight),
                                                       .pixel = key.number,
                                                       .samplerSeed = vertex.seed,
                                                       .medium = vertex.medium,
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

} // namespace hyalite::parity
