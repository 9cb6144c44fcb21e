// Photons sorted into a left-balanced kd-tree in heap order [Jensen01], built level by level from three sorted lists as
// in [Brown15] and stored as in [Wald22].
#pragma once

#include "render/wavefront/prefix_sum.h"

#include "shaders/shared/photon_map.h"

namespace hyalite::render {

class PhotonTree {
public:
    explicit PhotonTree(Device& device);

    // Sorts the stored photons among the first `slots` of `photons` into a tree, at `base` of `table`, which must have
    // room for all of them. The caller binds the table as TABLE_PHOTONS. Each node splits along the longest edge of the
    // box around its photons; ties are ordered by slot. Finishes the commands recorded so far once, to learn the number
    // of photons. Throws Error(BadInput) if the table is too small.
    void build(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots,
               const gpu::Array<shared::Photon>& table, std::uint32_t base);

    // For kernels that search photon maps, specialized to kPhotonTree.
    [[nodiscard]] shared::PhotonMapRecord map() const { return {order_, {}, {}, base_, photonCount_}; }
    [[nodiscard]] const gpu::Array<shared::uint>& order() const { return order_; } // slot of each node's photon
    [[nodiscard]] std::uint32_t photonCount() const { return photonCount_; }

private:
    void listPhotons(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots);
    void sortAlongAxes(Device& device);
    void splitLevels(Device& device);
    void reserve(Device& device);

    gpu::Kernel markPhotons_;
    gpu::Kernel keyPhotons_;
    gpu::Kernel countDigits_;
    gpu::Kernel sortDigits_;
    gpu::Kernel splitNodes_;
    gpu::Kernel countSides_;
    gpu::Kernel partSides_;
    gpu::Kernel finishSubtrees_;
    gpu::Kernel placePhotons_;
    PrefixSum prefixSum_;
    std::uint32_t base_ = 0;
    std::uint32_t photonCount_ = 0;

    gpu::Array<shared::uint> marks_;
    gpu::Array<shared::uint> numbers_;
    gpu::Array<shared::uint> slots_;       // of the stored photons
    gpu::Array<shared::KeyedPhoton> keys_; // of each stored photon; later, the splitting photon of each node of a level
    gpu::Array<shared::KeyedPhoton> even_; // the lists before every other level is split; before that, pairs to sort
    gpu::Array<shared::KeyedPhoton> odd_;  // the lists after it
    gpu::Array<shared::uint> counts_;
    gpu::Array<shared::uint> sums_;
    gpu::Array<shared::uint> nodes_;
    gpu::Array<shared::uint> order_;
};

} // namespace hyalite::render
