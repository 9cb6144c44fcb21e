// Shadow photons: followed straight through every surface, to decide which lights are visible from a point
// [JensenChristensen95].
#pragma once

#include "render/photons/photon_flight.h"

namespace hyalite::render {

class ShadowPhotonPaths {
public:
    // Keeps the references. `atOnce`: most photons in flight; more are cast in pieces, one after the other.
    ShadowPhotonPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t atOnce);

    // Casts `count` photons of all lights; each leaves a direct photon on the first diffuse surface, then shadow
    // photons on the later ones. They are in the first `slots` (the result) of photons(), with gaps where surface =
    // kNone.
    std::uint32_t cast(std::uint32_t count);

    [[nodiscard]] const gpu::Array<shared::Photon>& photons() const { return flight_.photons(); }
    [[nodiscard]] std::uint64_t raysTraced() const { return flight_.raysTraced(); }

private:
    // Casts `count` photons from `first` on, out of `ofPass` in the whole pass. Returns the number of slots that they
    // fill, from `firstSlot` on.
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
