#include "parity/twin_paths.h"

#include "reference/lib/sampling.h"
#include "scene/model/integrators.h"

#include <algorithm>

namespace hyalite::parity {

namespace {

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

PathState firstState(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass, Nudge nudge) {
    const reference::World& world = sides.world();
    if (key.isPhoton) {
        const reference::Emission emission = reference::emitPhoton(world, key.number, pass, nudge.shift());
        return {.ray = emission.ray,
                .camera = {},
                .photon = {.power = emission.power, .photon = key.number, .light = emission.light}};
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
