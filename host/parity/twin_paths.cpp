#include "parity/twin_paths.h"

#include "reference/sampling.h"

#include <algorithm>

namespace hyalite::parity {

namespace {

// The part of a vertex that follows from its ray and hit.
Vertex vertexAt(const Sides& sides, const reference::Ray& ray, const std::optional<reference::Hit>& hit,
                reference::Surface& surface) {
    Vertex vertex;
    vertex.from = ray.origin;
    vertex.direction = ray.direction;
    if (hit) {
        surface = reference::evaluateSurface(sides.world(), ray, *hit);
        vertex.position = surface.position;
        vertex.normal = surface.normal;
        vertex.front = surface.front;
        vertex.object = hit->object;
        vertex.primitive = hit->primitive;
        vertex.material = sides.numberOf(surface.material);
    }
    return vertex;
}

std::uint32_t wayOn(const reference::Surface& surface, const glm::dvec3& direction) {
    return glm::dot(direction, surface.geometricNormal) < 0 ? kTransmitted : kReflected;
}

void follow(const Sides& sides, const reference::Ray& ray, const reference::CameraPath& path, std::uint32_t depth,
            std::uint32_t pass, std::vector<Vertex>& vertices) {
    const auto hit = reference::traceClosest(sides.world(), ray);
    reference::Surface surface{};
    Vertex vertex = vertexAt(sides, ray, hit, surface);
    vertex.seed = path.samplerSeed;
    vertex.depth = depth;
    vertex.medium = sides.numberOf(path.medium);
    vertex.weight = path.beta;
    vertex.pdfW = path.pdfW;
    reference::Shading shading;
    if (hit) {
        shading = reference::shadeSurface(sides.world(), ray, *hit, path, depth, pass);
    }
    vertex.choice = shading.visible ? kDiffuseEnd : 0;
    for (const auto& next : shading.next) {
        vertex.choice |= next ? wayOn(surface, next->ray.direction) : 0;
    }
    vertices.push_back(vertex);
    for (const auto& next : shading.next) {
        if (next) {
            follow(sides, next->ray, next->path, depth + 1, pass, vertices);
        }
    }
}

} // namespace

std::vector<Vertex> twinCameraPath(const Sides& sides, std::uint32_t pixel, std::uint32_t pass) {
    std::vector<Vertex> vertices;
    follow(sides, reference::generateCameraRay(sides.world(), pixel, pass),
           reference::beginCameraPath(sides.world(), pixel, pass), 1, pass, vertices);
    std::ranges::stable_sort(vertices, {}, &Vertex::depth);
    return vertices;
}

std::vector<Vertex> twinPhotonPath(const Sides& sides, std::uint32_t photon, const reference::PhotonPass& pass) {
    const reference::Emission emission = reference::emitPhoton(sides.world(), photon, pass);
    reference::Ray ray = emission.ray;
    reference::PhotonPath path{.power = emission.power, .photon = photon, .light = emission.light};
    std::vector<Vertex> vertices;
    // The last segment of the longest path belongs to the camera
    for (std::uint32_t depth = 1; depth < sides.world().render.maxDepth; ++depth) {
        const auto hit = reference::traceClosest(sides.world(), ray);
        reference::Surface surface{};
        Vertex vertex = vertexAt(sides, ray, hit, surface);
        vertex.depth = depth;
        vertex.medium = sides.numberOf(path.medium);
        vertex.weight = path.power;
        std::optional<reference::PhotonScatter> scatter;
        if (hit) {
            scatter = reference::scatterPhoton(sides.world(), ray, *hit, path, depth, pass);
            vertex.choice = scatter->stored ? kStored : 0;
            vertex.choice |= scatter->next ? wayOn(surface, scatter->next->direction) : 0;
        }
        vertices.push_back(vertex);
        if (!scatter || !scatter->next) {
            break;
        }
        ray = *scatter->next;
        path = scatter->path;
    }
    return vertices;
}

std::vector<RandomNumbers> randomNumbersAt(const PathKey& path, const Vertex& vertex) {
    const shared::Sampler sampler =
        path.isPhoton ? shared::photonSampler(path.sequence, path.number) : shared::Sampler{vertex.seed, path.sequence};
    const std::uint32_t v = vertex.depth - 1;
    const auto pair = [&](std::uint32_t dimension) { return reference::sampleUnitSquare(sampler, dimension); };
    if (path.isPhoton) {
        return {{"roulette; lobe", pair(shared::photonScatter(v))}, {"direction", pair(shared::photonBounce(v))}};
    }
    return {{"lobe or diffuse", pair(shared::cameraScatter(v))},
            {"direction", pair(shared::cameraBounce(v))},
            {"light", pair(shared::cameraLightChoice(v))},
            {"point on it", pair(shared::cameraLightPoint(v))}};
}

} // namespace hyalite::parity
