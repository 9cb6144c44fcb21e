#include "render/photons/photon_paths.h"

#include "render/photons/photon_slots.h"

#include <algorithm>

namespace hyalite::render {

PhotonPaths::PhotonPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t atOnce)
    : device_(device), scene_(scene), deviceScene_(deviceScene),
      emitPhotons_(device.kernel("emit_photons", deviceScene.specialization)),
      emitCausticPhotons_(device.kernel("emit_caustic_photons", deviceScene.specialization)),
      traceClosest_(device.kernel("trace_closest", deviceScene.specialization)),
      scatterPhoton_(device.kernel("scatter_photon", deviceScene.specialization)), compaction_(device),
      queue_(device.context, atOnce) {}

std::uint32_t PhotonPaths::trace(const PhotonPass& pass) {
    if (pass.account) {
        openAccount(pass);
    }
    std::uint32_t slots = 0;
    for (std::uint32_t first = 0; first < pass.count; first += queue_.capacity()) {
        if (first > 0) { // room for all that is to be expected: to grow later would keep old and new side by side
            const double expected = 1.03 * double(slots) / double(first) * double(pass.count);
            reservePhotonSlots(device_, photons_, static_cast<std::uint32_t>(std::min(expected, 4.0e9)));
        }
        slots += tracePiece(pass, first, std::min(queue_.capacity(), pass.count - first), slots);
    }
    if (pass.account) {
        closeAccount();
    }
    return slots;
}

std::uint32_t PhotonPaths::tracePiece(const PhotonPass& pass, std::uint32_t first, std::uint32_t count,
                                      std::uint32_t firstSlot) {
    gpu::Commands& commands = device_.commands;
    PhotonQueue& queue = queue_;
    const std::uint32_t maxDepth = scene_.render.maxDepth;
    // Where direct photons are not stored, nothing is after the first segment: its slots are used again
    const std::uint32_t firstStored = (pass.kinds & 1U << shared::kPhotonDirect) != 0 ? 1 : 2;
    std::uint32_t slots = firstSlot;
    queue.count = count;
    emit(pass, first);
    if (pass.account) {
        enterEmitted(first);
    }
    for (std::uint32_t depth = 1; queue.count > 0 && depth < maxDepth; ++depth) {
        reservePhotonSlots(device_, photons_, slots + queue.count);
        commands.run(traceClosest_,
                     shared::TraceClosestArguments{queue.rays, queue.hits, queue.count, deviceScene_.rootNode,
                                                   /*width*/ 0},
                     queue.count);
        commands.run(scatterPhoton_,
                     shared::ScatterPhotonArguments{queue.rays, queue.hits, queue.paths, deviceScene_.materials,
                                                    deviceScene_.normals, deviceScene_.instances, photons_, fates_,
                                                    queue.nextRays, queue.nextPaths, queue.alive, queue.count, slots,
                                                    depth, maxDepth, pass.sequence, pass.kinds, pass.account ? 1U : 0U},
                     queue.count);
        raysTraced_ += queue.count;
        slots += depth >= firstStored ? queue.count : 0;
        compaction_.run(device_, queue, queue.count);
    }
    return slots - firstSlot;
}

void PhotonPaths::emit(const PhotonPass& pass, std::uint32_t first) {
    const std::uint32_t count = queue_.count;
    if (pass.aimed) {
        device_.commands.run(emitCausticPhotons_,
                             shared::EmitCausticPhotonsArguments{
                                 deviceScene_.lights, deviceScene_.targets, queue_.rays, queue_.paths, first, count,
                                 pass.count, deviceScene_.lightCount, deviceScene_.targetCount, pass.sequence},
                             count);
        return;
    }
    device_.commands.run(emitPhotons_,
                         shared::EmitPhotonsArguments{deviceScene_.lights, queue_.rays, queue_.paths, first, count,
                                                      pass.count, deviceScene_.lightCount, pass.sequence},
                         count);
}

void PhotonPaths::openAccount(const PhotonPass& pass) {
    device_.commands.finish();
    balance_.assign(deviceScene_.lightCount, {});
    lightOf_.resize(pass.count);
    if (fates_.count() < pass.count) {
        fates_ = {device_.context, pass.count, "photon fates"};
    }
    std::ranges::fill(fates_.host().first(pass.count), shared::PhotonFate{});
}

void PhotonPaths::enterEmitted(std::uint32_t first) {
    device_.commands.finish();
    for (std::uint32_t i = 0; i < queue_.count; ++i) {
        const shared::PhotonPath& path = queue_.paths.host()[i];
        lightOf_[first + i] = path.light;
        balance_.at(path.light).emitted += path.power;
    }
}

void PhotonPaths::closeAccount() {
    device_.commands.finish();
    for (std::size_t i = 0; i < lightOf_.size(); ++i) {
        const shared::PhotonFate& fate = fates_.host()[i];
        LightBalance& balance = balance_.at(lightOf_[i]);
        balance.stored += fate.stored;
        balance.absorbed += fate.absorbed;
        balance.escaped += fate.escaped;
        balance.cutOff += fate.cutOff;
    }
}

} // namespace hyalite::render
