// Photons sorted into a hashed grid by counting: count, scan, scatter, then sort each bucket so that later sums are
// reproducible.
#pragma once

#include "render/wavefront/prefix_sum.h"

#include "shaders/shared/photon_map.h"

namespace hyalite::render {

class PhotonGrid {
public:
    explicit PhotonGrid(Device& device);

    // Sorts the stored photons among the first `slots` of `photons` into a grid for searches of `radius` [m] and binds
    // them as the photon table. Finishes the commands recorded so far once, to learn the number of photons.
    void build(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots, float radius);

    // The same, but writes the photons to `table` from `base` on; the caller binds it as TABLE_PHOTONS, and it must
    // have room for all of them. Throws Error(BadInput) if it has not.
    void build(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots, float radius,
               const gpu::Array<shared::Photon>& table, std::uint32_t base);

    // For kernels that search photon maps, specialized to kPhotonGrid.
    [[nodiscard]] shared::PhotonMapRecord map() const { return {order_, cellStarts_, grid_, base_, photonCount_}; }
    [[nodiscard]] const gpu::Array<shared::uint>& order() const { return order_; } // slot of each sorted photon
    [[nodiscard]] const gpu::Array<shared::uint>& cellStarts() const { return cellStarts_; }
    [[nodiscard]] const gpu::Array<shared::Photon>& sorted() const { return sorted_; }
    [[nodiscard]] shared::GridRecord record() const { return grid_; }
    [[nodiscard]] std::uint32_t photonCount() const { return photonCount_; }

private:
    void reserve(Device& device, std::uint32_t slots);
    void listByCell(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots, float radius);

    gpu::Kernel countCells_;
    gpu::Kernel fillCells_;
    gpu::Kernel orderCells_;
    gpu::Kernel sortPhotons_;
    PrefixSum prefixSum_;
    shared::GridRecord grid_{};
    std::uint32_t base_ = 0;
    std::uint32_t photonCount_ = 0;
    gpu::Array<shared::uint> cellCounts_;
    gpu::Array<shared::uint> cellStarts_;
    gpu::Array<shared::uint> ranks_;
    gpu::Array<shared::uint> order_;
    gpu::Array<shared::Photon> sorted_;
};

} // namespace hyalite::render
