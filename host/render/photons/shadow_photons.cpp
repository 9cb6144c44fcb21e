#include "render/photons/shadow_photons.h"

#include "scene/model/render_seed.h"

#include <algorithm>

namespace hyalite::render {

ShadowPhotonPaths::ShadowPhotonPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene,
                                     std::uint32_t atOnce)
    : device_(device), scene_(scene), deviceScene_(deviceScene),
      emitPhotons_(device.kernel("emit_photons", deviceScene.specialization)),
      castShadowPhotons_(device.kernel("cast_shadow_photons", deviceScene.specialization)),
      flight_(device, deviceScene, atOnce) {}

std::uint32_t ShadowPhotonPaths::cast(std::uint32_t count) {
    const std::uint32_t atOnce = flight_.queue().capacity();
    std::uint32_t slots = 0;
    for (std::uint32_t first = 0; first < count; first += atOnce) {
        slots += castPiece(first, std::min(atOnce, count - first), count, slots);
    }
    return slots;
}

std::uint32_t ShadowPhotonPaths::castPiece(std::uint32_t first, std::uint32_t count, std::uint32_t ofPass,
                                           std::uint32_t firstSlot) {
    return flight_.follow({.count = count,
                           .firstSlot = firstSlot,
                           .maxDepth = shared::kMaxDepth,
                           .storesFirst = true,
                           .onlyOnce = false,
                           .emit = [&] { emit(first, count, ofPass); },
                           .atHits = [&](const PhotonFlight::Bounce& bounce) { pass(bounce); }});
}

void ShadowPhotonPaths::emit(std::uint32_t first, std::uint32_t count, std::uint32_t ofPass) {
    const PhotonQueue& queue = flight_.queue();
    device_.commands.run(emitPhotons_,
                         shared::EmitPhotonsArguments{
                             .lights = deviceScene_.lights,
                             .rays = queue.rays,
                             .paths = queue.paths,
                             .first = first,
                             .count = count,
                             .ofPass = ofPass,
                             .lightCount = deviceScene_.lightCount,
                             .sequence = shared::photonSequence(renderSeed(scene_.render), shared::kShadowPhotons, 0)},
                         count);
}

void ShadowPhotonPaths::pass(const PhotonFlight::Bounce& bounce) {
    const PhotonQueue& queue = flight_.queue();
    device_.commands.run(castShadowPhotons_,
                         shared::CastShadowPhotonsArguments{.rays = queue.rays,
                                                            .hits = queue.hits,
                                                            .paths = queue.paths,
                                                            .materials = deviceScene_.materials,
                                                            .normals = deviceScene_.normals,
                                                            .instances = deviceScene_.instances,
                                                            .photons = flight_.photons(),
                                                            .nextRays = queue.nextRays,
                                                            .nextPaths = queue.nextPaths,
                                                            .alive = queue.alive,
                                                            .count = bounce.photons.most(),
                                                            .firstPhoton = bounce.firstPhoton,
                                                            .room = flight_.room(),
                                                            .live = bounce.photons.live()},
                         bounce.photons);
}

} // namespace hyalite::render
