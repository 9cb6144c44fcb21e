#include "render/photons/shadow_photons.h"

#include "render/photons/photon_slots.h"
#include "scene/model/render_seed.h"

#include <algorithm>

namespace hyalite::render {

ShadowPhotonPaths::ShadowPhotonPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene,
                                     std::uint32_t atOnce)
    : device_(device), scene_(scene), deviceScene_(deviceScene),
      emitPhotons_(device.kernel("emit_photons", deviceScene.specialization)),
      traceClosest_(device.kernel("trace_closest", deviceScene.specialization)),
      castShadowPhotons_(device.kernel("cast_shadow_photons", deviceScene.specialization)), compaction_(device),
      queue_(device.context, atOnce) {}

std::uint32_t ShadowPhotonPaths::cast(std::uint32_t count) {
    std::uint32_t slots = 0;
    for (std::uint32_t first = 0; first < count; first += queue_.capacity()) {
        queue_.count = std::min(queue_.capacity(), count - first);
        slots = castPiece(first, count, slots);
    }
    return slots;
}

std::uint32_t ShadowPhotonPaths::castPiece(std::uint32_t first, std::uint32_t ofPass, std::uint32_t slots) {
    gpu::Commands& commands = device_.commands;
    PhotonQueue& queue = queue_;
    const std::uint32_t sequence = shared::photonSequence(renderSeed(scene_.render), shared::kShadowPhotons, 0);
    commands.run(emitPhotons_,
                 shared::EmitPhotonsArguments{deviceScene_.lights, queue.rays, queue.paths, first, queue.count, ofPass,
                                              deviceScene_.lightCount, sequence},
                 queue.count);
    for (std::uint32_t depth = 1; queue.count > 0 && depth <= shared::kMaxDepth; ++depth) {
        reservePhotonSlots(device_, photons_, slots + queue.count);
        commands.run(traceClosest_,
                     shared::TraceClosestArguments{queue.rays, queue.hits, queue.count, deviceScene_.rootNode,
                                                   /*width*/ 0},
                     queue.count);
        commands.run(castShadowPhotons_,
                     shared::CastShadowPhotonsArguments{queue.rays, queue.hits, queue.paths, deviceScene_.materials,
                                                        deviceScene_.normals, deviceScene_.instances, photons_,
                                                        queue.nextRays, queue.nextPaths, queue.alive, queue.count,
                                                        slots},
                     queue.count);
        raysTraced_ += queue.count;
        slots += queue.count;
        compaction_.run(device_, queue, queue.count);
    }
    return slots;
}

} // namespace hyalite::render
