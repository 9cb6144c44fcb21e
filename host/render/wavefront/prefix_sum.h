// Exclusive prefix sums on the device, the building block of queues and of the photon grid.
#pragma once

#include "render/wavefront/queue_sizes.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::render {

class PrefixSum {
public:
    explicit PrefixSum(Device& device);

    // Records sums[i] = values[0] + … + values[i-1] for i = 0 … count; sums holds count + 1 values, values count >= 1.
    void run(Device& device, const gpu::Array<shared::uint>& values, const gpu::Array<shared::uint>& sums,
             std::uint32_t count);

    // Records the same of as many values as the queue has elements, or chunks of kScanChunk^level elements. The total
    // is how many elements the queue will have next: it becomes sizes.next().
    struct OfQueue {
        const QueueSizes& sizes;
        std::uint32_t level = 0;
        shared::UintArray elementCount = {}; // a DeviceCounter: the queue's elements are added to it; none: no
    };
    void run(Device& device, const gpu::Array<shared::uint>& values, const gpu::Array<shared::uint>& sums,
             const OfQueue& queue);

private:
    // Of the values of each level how many there are, the first level's first.
    struct Counts {
        const OfQueue* queue = nullptr;
        std::uint32_t count = 0; // without a queue
        [[nodiscard]] gpu::ThreadCount at(std::uint32_t level) const;
    };
    void reserve(Device& device, const Counts& counts);
    void scan(Device& device, shared::UintArray values, shared::UintArray sums, const Counts& counts,
              std::uint32_t level);

    gpu::Kernel scanGroup_;
    gpu::Kernel sumChunks_;
    gpu::Kernel scanChunks_;
    // Sums of chunks, of chunks of chunks … and, beside them, what precedes each
    struct Level {
        gpu::Array<shared::uint> sums;
        gpu::Array<shared::uint> offsets;
    };
    std::vector<Level> levels_;
};

} // namespace hyalite::render
