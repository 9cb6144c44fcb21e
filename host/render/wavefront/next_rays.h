// The next rays of paths, in the paths' own slots: lists the slots in use.
#pragma once

#include "render/wavefront/prefix_sum.h"

namespace hyalite::render {

class NextRays {
public:
    explicit NextRays(Device& device);

    // Records the count of the next rays of the queue's paths, the sum of `alive`: it becomes sizes.next().
    void count(Device& device, const gpu::Array<shared::uint>& alive, const QueueSizes& sizes);

    // After count, for the same paths: records writing their used slots to `slots`, in order, up to its capacity. A
    // path has `slotsOfPath` slots, and uses the first of them.
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
