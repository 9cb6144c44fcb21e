// Photons sorted into a hashed grid by counting: count, scan, scatter, and an order inside each bucket that makes
// every later sum reproducible.
#pragma once

#include "render/wavefront/prefix_sum.h"

#include "shaders/shared/photon_map.h"

namespace hyalite::render {

class PhotonGrid {
public:
    explicit PhotonGrid(Device& device);

    // Sorts the stored photons among the first `slots` of `photons` into a grid for searches of `radius` [m] and shows
    // them in the photon table. Finishes the commands recorded so far once, to learn how many photons there are.
    void build(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots, float radius);

    // The same, but the photons go to `base` of `table`, which the caller shows as TABLE_PHOTONS; there must be room
    // for all of them. Throws Error(BadInput) where there is not.
    void build(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots, float radius,
               const gpu::Array<shared::Photon>& table, std::uint32_t base);

    // For kernels that search photon maps, specialised to kPhotonGrid.
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
