// The rays that paths leave, in slots of theirs: which slots hold one.
#pragma once

#include "render/wavefront/prefix_sum.h"

namespace hyalite::render {

class NextRays {
public:
    explicit NextRays(const Device& device);

    // How many rays the first `paths` leave: the sum of `alive`. Finishes the commands recorded so far.
    [[nodiscard]] std::uint32_t count(Device& device, const gpu::Array<shared::uint>& alive, std::uint32_t paths);

    // After count, for the same paths: records that their slots are written to `slots`, in order. A path has
    // `slotsOfPath`, and uses the first of them.
    void list(Device& device, const gpu::Array<shared::uint>& alive, std::uint32_t paths, std::uint32_t slotsOfPath,
              const gpu::Array<shared::uint>& slots) const;

private:
    gpu::Kernel sumChunks_;
    gpu::Kernel listNextRays_;
    PrefixSum prefixSum_;
    gpu::Array<shared::uint> chunkSums_;
    gpu::Array<shared::uint> chunkOffsets_;
};

} // namespace hyalite::render
