// Exclusive prefix sums on the device, the building block of queues and of the photon grid.
#pragma once

#include "render/wavefront/device.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::render {

class PrefixSum {
public:
    explicit PrefixSum(const Device& device);

    // Records sums[i] = values[0] + … + values[i-1] for i = 0 … count; sums holds count + 1 values, values count >= 1.
    void run(Device& device, const gpu::Array<shared::uint>& values, const gpu::Array<shared::uint>& sums,
             std::uint32_t count);

private:
    void scan(Device& device, shared::UintArray values, shared::UintArray sums, std::uint32_t count, std::size_t level);

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
