// Photon paths: emitted, followed from bounce to bounce, and stored where they land.
#pragma once

#include "render/photons/light_balance.h"
#include "render/photons/photon_flight.h"

namespace hyalite::render {

// The photons of one purpose and one pass.
struct PhotonPass {
    std::uint32_t sequence = 0; // see shared::photonSequence
    std::uint32_t count = 0;    // emitted
    std::uint32_t kinds = 0;    // bit kPhoton… is set for every kind that is stored; paths that can store no more end
    bool aimed = false;         // emit only towards what is specular
    bool account = false;       // keep account of what becomes of each photon's flux
};

class PhotonPaths {
public:
    // References are kept. `atOnce`: photons in flight at most; a pass of more is traced in pieces, one after the
    // other.
    PhotonPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t atOnce);

    // Traces a pass. Its photons stand in the first `slots` (the result) of photons(), in a fixed order and with gaps
    // where surface = kNone.
    std::uint32_t trace(const PhotonPass& pass);

    [[nodiscard]] const gpu::Array<shared::Photon>& photons() const { return flight_.photons(); }
    [[nodiscard]] std::uint64_t raysTraced() const { return flight_.raysTraced(); }

    // Per light, of the last pass that kept account.
    [[nodiscard]] const std::vector<LightBalance>& balance() const { return balance_; }

private:
    // Of `count` photons from `first` on. The result: the slots that they fill, from `firstSlot` on.
    std::uint32_t tracePiece(const PhotonPass& pass, std::uint32_t first, std::uint32_t count, std::uint32_t firstSlot);
    void emit(const PhotonPass& pass, std::uint32_t first, std::uint32_t count);
    void scatter(const PhotonPass& pass, const PhotonFlight::Bounce& bounce);
    void openAccount(const PhotonPass& pass);
    void enterEmitted(std::uint32_t first, std::uint32_t count);
    void closeAccount();

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    gpu::Kernel emitPhotons_;
    gpu::Kernel emitCausticPhotons_;
    gpu::Kernel scatterPhoton_;
    PhotonFlight flight_;
    gpu::Array<shared::PhotonFate> fates_;
    std::vector<std::uint32_t> lightOf_; // per photon, while an account is open
    std::vector<LightBalance> balance_;
};

} // namespace hyalite::render
