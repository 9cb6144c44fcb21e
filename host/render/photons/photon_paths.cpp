#include "render/photons/photon_paths.h"

#include <algorithm>

namespace hyalite::render {

PhotonPaths::PhotonPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t atOnce)
    : device_(device), scene_(scene), deviceScene_(deviceScene),
      emitPhotons_(device.kernel("emit_photons", deviceScene.specialization)),
      emitCausticPhotons_(device.kernel("emit_caustic_photons", deviceScene.specialization)),
      scatterPhoton_(device.kernel("scatter_photon", deviceScene.specialization)),
      flight_(device, deviceScene, atOnce) {}

std::uint32_t PhotonPaths::trace(const PhotonPass& pass) {
    if (pass.account) {
        openAccount(pass);
    }
    const std::uint32_t atOnce = flight_.queue().capacity();
    std::uint32_t slots = 0;
    for (std::uint32_t first = 0; first < pass.count; first += atOnce) {
        if (first > 0) { // room for all that is to be expected: to grow later would keep old and new side by side
            const double expected = 1.03 * double(slots) / double(first) * double(pass.count);
            flight_.reserve(static_cast<std::uint64_t>(std::min(expected, 4.0e9)));
        }
        slots += tracePiece(pass, first, std::min(atOnce, pass.count - first), slots);
    }
    if (pass.account) {
        closeAccount();
    }
    return slots;
}

std::uint32_t PhotonPaths::tracePiece(const PhotonPass& pass, std::uint32_t first, std::uint32_t count,
                                      std::uint32_t firstSlot) {
    return flight_.follow({.count = count,
                           .firstSlot = firstSlot,
                           // The last segment belongs to the camera
                           .maxDepth = scene_.render.maxDepth - std::min(scene_.render.maxDepth, 1U),
                           .storesFirst = (pass.kinds & 1U << shared::kPhotonDirect) != 0,
                           .onlyOnce = pass.account,
                           .emit =
                               [&] {
                                   emit(pass, first, count);
                                   if (pass.account) {
                                       enterEmitted(first, count);
                                   }
                               },
                           .atHits = [&](const PhotonFlight::Bounce& bounce) { scatter(pass, bounce); }});
}

void PhotonPaths::scatter(const PhotonPass& pass, const PhotonFlight::Bounce& bounce) {
    const PhotonQueue& queue = flight_.queue();
    device_.commands.run(scatterPhoton_,
                         shared::ScatterPhotonArguments{.rays = queue.rays,
                                                        .hits = queue.hits,
                                                        .paths = queue.paths,
                                                        .materials = deviceScene_.materials,
                                                        .normals = deviceScene_.normals,
                                                        .instances = deviceScene_.instances,
                                                        .photons = flight_.photons(),
                                                        .fates = fates_,
                                                        .nextRays = queue.nextRays,
                                                        .nextPaths = queue.nextPaths,
                                                        .alive = queue.alive,
                                                        .count = bounce.photons.most(),
                                                        .firstPhoton = bounce.firstPhoton,
                                                        .depth = bounce.depth,
                                                        .maxDepth = scene_.render.maxDepth,
                                                        .sequence = pass.sequence,
                                                        .kinds = pass.kinds,
                                                        .account = pass.account ? 1U : 0U,
                                                        .room = flight_.room(),
                                                        .live = bounce.photons.live()},
                         bounce.photons);
}

void PhotonPaths::emit(const PhotonPass& pass, std::uint32_t first, std::uint32_t count) {
    const PhotonQueue& queue = flight_.queue();
    if (pass.aimed) {
        device_.commands.run(emitCausticPhotons_,
                             shared::EmitCausticPhotonsArguments{.lights = deviceScene_.lights,
                                                                 .targets = deviceScene_.targets,
                                                                 .rays = queue.rays,
                                                                 .paths = queue.paths,
                                                                 .first = first,
                                                                 .count = count,
                                                                 .ofPass = pass.count,
                                                                 .lightCount = deviceScene_.lightCount,
                                                                 .targetCount = deviceScene_.targetCount,
                                                                 .sequence = pass.sequence},
                             count);
        return;
    }
    device_.commands.run(emitPhotons_,
                         shared::EmitPhotonsArguments{.lights = deviceScene_.lights,
                                                      .rays = queue.rays,
                                                      .paths = queue.paths,
                                                      .first = first,
                                                      .count = count,
                                                      .ofPass = pass.count,
                                                      .lightCount = deviceScene_.lightCount,
                                                      .sequence = pass.sequence},
                         count);
}

void PhotonPaths::openAccount(const PhotonPass& pass) {
    balance_.assign(deviceScene_.lightCount, {});
    lightOf_.resize(pass.count);
    if (fates_.count() < pass.count) {
        device_.commands.finish();
        fates_ = {device_.context, pass.count, "photon fates"};
    }
    device_.commands.clear(fates_.buffer());
}

void PhotonPaths::enterEmitted(std::uint32_t first, std::uint32_t count) {
    device_.commands.finish();
    for (const shared::PhotonPath& path : flight_.queue().paths.read(0, count)) {
        lightOf_[first++] = path.light;
        balance_.at(path.light).emitted += path.power;
    }
}

void PhotonPaths::closeAccount() {
    device_.commands.finish();
    const std::vector<shared::PhotonFate> fates = fates_.read(0, lightOf_.size());
    for (std::size_t i = 0; i < lightOf_.size(); ++i) {
        LightBalance& balance = balance_.at(lightOf_[i]);
        balance.stored += fates[i].stored;
        balance.absorbed += fates[i].absorbed;
        balance.escaped += fates[i].escaped;
        balance.cutOff += fates[i].cutOff;
    }
}

} // namespace hyalite::render
