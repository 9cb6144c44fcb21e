// Shadow photons: followed straight on through everything, so that a place can tell which lights it sees
// [JensenChristensen95].
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/path_queue.h"

namespace hyalite::render {

class ShadowPhotonPaths {
public:
    // References are kept. `atOnce`: photons in flight at most; more are cast in pieces, one after the other.
    ShadowPhotonPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t atOnce);

    // Casts `count` photons of all lights; on every diffuse surface in its way each leaves a direct photon first, then
    // shadow photons. They stand in the first `slots` (the result) of photons(), with gaps where surface = kNone.
    std::uint32_t cast(std::uint32_t count);

    [[nodiscard]] const gpu::Array<shared::Photon>& photons() const { return photons_; }
    [[nodiscard]] std::uint64_t raysTraced() const { return raysTraced_; }

private:
    // Of the photons in the queue, numbered from `first` on; their slots begin at `slots`. The result: where they end.
    std::uint32_t castPiece(std::uint32_t first, std::uint32_t ofPass, std::uint32_t slots);

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    gpu::Kernel emitPhotons_;
    gpu::Kernel traceClosest_;
    gpu::Kernel castShadowPhotons_;
    PhotonCompaction compaction_;
    PhotonQueue queue_;
    gpu::Array<shared::Photon> photons_;
    std::uint64_t raysTraced_ = 0;
};

} // namespace hyalite::render
