#include "render/photon_paths.h"

#include <algorithm>

namespace hyalite::render {

PhotonPaths::PhotonPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t capacity)
    : device_(device), scene_(scene), deviceScene_(deviceScene), emitPhotons_(device.kernel("emit_photons")),
      traceClosest_(device.kernel("trace_closest", deviceScene.specialization)),
      scatterPhoton_(device.kernel("scatter_photon", deviceScene.specialization)),
      compactPhotonPaths_(device.kernel("compact_photon_paths")), prefixSum_(device), queue_(device.context, capacity) {
}

std::uint32_t PhotonPaths::trace(const PhotonPass& pass) {
    gpu::Commands& commands = device_.commands;
    PhotonQueue& queue = queue_;
    const std::uint32_t maxDepth = scene_.render.maxDepth;
    // Where direct photons are not stored, nothing is after the first segment: its slots are used again
    const std::uint32_t firstStored = (pass.kinds & 1U << shared::kPhotonDirect) != 0 ? 1 : 2;
    std::uint32_t slots = 0;
    queue.count = pass.count;
    commands.run(emitPhotons_,
                 shared::EmitPhotonsArguments{deviceScene_.lights, queue.rays, queue.paths, queue.count,
                                              deviceScene_.lightCount, pass.sequence},
                 queue.count);
    for (std::uint32_t depth = 1; queue.count > 0 && depth < maxDepth; ++depth) {
        reserve(slots + queue.count);
        commands.run(traceClosest_,
                     shared::TraceClosestArguments{queue.rays, queue.hits, queue.count, deviceScene_.rootNode},
                     queue.count);
        commands.run(scatterPhoton_,
                     shared::ScatterPhotonArguments{
                         queue.rays, queue.hits, queue.paths, deviceScene_.materials, deviceScene_.normals,
                         deviceScene_.instances, photons_, shared::PhotonFateArray{}, queue.nextRays, queue.nextPaths,
                         queue.alive, queue.count, slots, depth, maxDepth, pass.sequence, pass.kinds, /*account*/ 0},
                     queue.count);
        raysTraced_ += queue.count;
        slots += depth >= firstStored ? queue.count : 0;
        const std::uint32_t alive = countAlive(device_, prefixSum_, queue, queue.count);
        commands.run(compactPhotonPaths_,
                     shared::CompactPhotonPathsArguments{queue.alive, queue.offsets, queue.nextRays, queue.nextPaths,
                                                         queue.rays, queue.paths, queue.count},
                     alive > 0 ? queue.count : 0);
        queue.count = alive;
    }
    return slots;
}

void PhotonPaths::reserve(std::uint32_t slots) {
    if (photons_.count() >= slots) {
        return;
    }
    device_.commands.finish();
    gpu::Array<shared::Photon> larger(device_.context, std::max<std::size_t>(slots, 2 * photons_.count()), "photons");
    std::ranges::copy(photons_.host(), larger.host().begin());
    photons_ = std::move(larger);
}

} // namespace hyalite::render
