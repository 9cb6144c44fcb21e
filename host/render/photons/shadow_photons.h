// Shadow photons: followed straight on through everything, so that a place can tell which lights it sees
// [JensenChristensen95].
#pragma once

#include "render/photons/photon_flight.h"

namespace hyalite::render {

class ShadowPhotonPaths {
public:
    // References are kept. `atOnce`: photons in flight at most; more are cast in pieces, one after the other.
    ShadowPhotonPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t atOnce);

    // Casts `count` photons of all lights; on every diffuse surface in its way each leaves a direct photon first, then
    // shadow photons. They stand in the first `slots` (the result) of photons(), with gaps where surface = kNone.
    std::uint32_t cast(std::uint32_t count);

    [[nodiscard]] const gpu::Array<shared::Photon>& photons() const { return flight_.photons(); }
    [[nodiscard]] std::uint64_t raysTraced() const { return flight_.raysTraced(); }

private:
    // Of `count` photons from `first` on, of a pass of so many. The result: the slots that they fill, from `firstSlot`.
    std::uint32_t castPiece(std::uint32_t first, std::uint32_t count, std::uint32_t ofPass, std::uint32_t firstSlot);
    void emit(std::uint32_t first, std::uint32_t count, std::uint32_t ofPass);
    void pass(const PhotonFlight::Bounce& bounce);

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    gpu::Kernel emitPhotons_;
    gpu::Kernel castShadowPhotons_;
    PhotonFlight flight_;
};

} // namespace hyalite::render
