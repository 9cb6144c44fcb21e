// The rays that paths leave, in slots of theirs: which slots hold one.
#pragma once

#include "render/wavefront/prefix_sum.h"

namespace hyalite::render {

class NextRays {
public:
    explicit NextRays(Device& device);

    // Records the count of the rays that the queue's paths leave, the sum of `alive`: it becomes sizes.next().
    void count(Device& device, const gpu::Array<shared::uint>& alive, const QueueSizes& sizes);

    // After count, for the same paths: records that their slots are written to `slots`, in order, as far as it has
    // room. A path has `slotsOfPath`, and uses the first of them.
    void list(Device& device, const gpu::Array<shared::uint>& alive, const QueueSizes& sizes, std::uint32_t slotsOfPath,
              const gpu::Array<shared::uint>& slots);

private:
    gpu::Kernel sumChunks_;
    gpu::Kernel listNextRays_;
    PrefixSum prefixSum_;
    gpu::Array<shared::uint> chunkSums_;
    gpu::Array<shared::uint> chunkOffsets_;
};

} // namespace hyalite::render
