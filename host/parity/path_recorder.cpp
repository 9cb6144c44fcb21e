#include "parity/path_recorder.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

// The part of a vertex determined by its ray and hit.
DeviceVertex vertexAt(const Sides& sides, const shared::Ray& ray, const shared::Hit& hit,
                      std::optional<reference::Surface>& surface) {
    DeviceVertex vertex;
    vertex.ray = ray;
    vertex.hit = hit;
    vertex.from = dvec3(ray.origin);
    vertex.direction = dvec3(ray.direction);
    const auto met = sides.toTwin(hit);
    surface.reset();
    if (met) {
        surface = reference::evaluateSurface(sides.world(), sides.toTwin(ray), *met);
        setSurface(vertex, sides, *met, *surface);
    }
    return vertex;
}

std::uint32_t continuationFrom(const std::optional<reference::Surface>& surface, const shared::Ray& next) {
    return surface ? continuation(*surface, dvec3(next.direction)) : kReflected;
}

} // namespace

void PathRecorder::addShading(const Shaded& shaded, std::uint32_t depth, std::uint32_t pass) {
    if (!isRecording_ || leavesOut(shaded.path.pixel)) {
        return;
    }
    std::optional<reference::Surface> surface;
    DeviceVertex vertex = vertexAt(sides_, shaded.ray, shaded.hit, surface);
    vertex.seed = shaded.path.samplerSeed;
    vertex.depth = depth;
    vertex.media = shaded.path.media;
    vertex.medium = sides_.mediumOf(vertex.media);
    vertex.weight = dvec3(shaded.path.beta);
    vertex.pdfW = double{shaded.path.pdfW};
    // A path that bounces off diffuse surfaces may have stored its visible point at an earlier one
    vertex.choice = shaded.visible.depth == depth && sides_.reflects(shaded.visible) ? kDiffuse : 0;
    for (const shared::Ray& next : shaded.next) {
        vertex.choice |= continuationFrom(surface, next);
    }
    paths_[{false, pass, shaded.path.pixel}].push_back(vertex);
}

void PathRecorder::addBounce(std::uint32_t pass, std::uint32_t pixel) {
    if (isRecording_ && !leavesOut(pixel)) {
        paths_[{false, pass, pixel}].back().choice |= kBounced;
    }
}

bool PathRecorder::hasEnded(const PathKey& key) const {
    const auto found = paths_.find(key);
    return found != paths_.end() && !found->second.empty() &&
           (found->second.back().choice & (kDiffuse | kBounced)) == kDiffuse;
}

void PathRecorder::beginPhotonPass(const reference::PhotonPass& pass) {
    if (photonPasses_.size() < kRecordedPasses) {
        photonPasses_[pass.sequence].pass = pass;
    }
}

bool PathRecorder::setPhotonPass(std::uint32_t sequence, std::uint32_t kinds, std::uint32_t maxDepth) {
    const auto pass = photonPasses_.find(sequence);
    if (pass == photonPasses_.end()) {
        return false;
    }
    pass->second.pass.kinds = kinds;
    pass->second.maxDepth = maxDepth;
    return true;
}

void PathRecorder::addScattering(const Scattered& scattered, std::uint32_t depth, std::uint32_t sequence) {
    if (leavesOut(scattered.path.photon)) {
        return;
    }
    std::optional<reference::Surface> surface;
    DeviceVertex vertex = vertexAt(sides_, scattered.ray, scattered.hit, surface);
    vertex.depth = depth;
    vertex.media = scattered.path.media;
    vertex.medium = sides_.mediumOf(vertex.media);
    vertex.weight = dvec3(scattered.path.power);
    vertex.photonKind = scattered.path.kind;
    vertex.light = scattered.path.light;
    vertex.choice = scattered.isStored ? kStored : 0;
    vertex.choice |= scattered.next != nullptr ? continuationFrom(surface, *scattered.next) : 0;
    paths_[{true, sequence, scattered.path.photon}].push_back(vertex);
}

} // namespace hyalite::parity
