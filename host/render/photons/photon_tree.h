// Photons sorted into a left-balanced kd-tree in heap order [Jensen01], built level by level from three sorted lists as
// in [Brown15] and laid out as in [Wald22].
#pragma once

#include "render/wavefront/prefix_sum.h"

#include "shaders/shared/photon_map.h"

namespace hyalite::render {

class PhotonTree {
public:
    explicit PhotonTree(Device& device);

    // Sorts the stored photons among the first `slots` of `photons` into a tree, at `base` of `table`; there must be
    // room for all of them. The caller shows the table as TABLE_PHOTONS. Each node splits along the longest edge of the
    // box about its photons; of equal coordinates the lower slot is the lesser. Finishes the commands recorded so far
    // once, to learn how many photons there are.
    // Throws Error(BadInput) where the table has not the room.
    void build(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots,
               const gpu::Array<shared::Photon>& table, std::uint32_t base);

    // For kernels that search photon maps, specialised to kPhotonTree.
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
    gpu::Array<shared::KeyedPhoton> keys_; // of each stored photon; later, what splits each node of a level
    gpu::Array<shared::KeyedPhoton> even_; // the lists before every other level is split; before that, room for pairs
    gpu::Array<shared::KeyedPhoton> odd_;  // the lists after it
    gpu::Array<shared::uint> counts_;
    gpu::Array<shared::uint> sums_;
    gpu::Array<shared::uint> nodes_;
    gpu::Array<shared::uint> order_;
};

} // namespace hyalite::render
