#include "render/wavefront/next_rays.h"

namespace hyalite::render {

NextRays::NextRays(Device& device)
    : sumChunks_(device.kernel("sum_chunks")), listNextRays_(device.kernel("list_next_rays")), prefixSum_(device) {}

void NextRays::count(Device& device, const gpu::Array<shared::uint>& alive, const QueueSizes& sizes) {
    const gpu::ThreadCount paths = sizes.threads();
    const gpu::ThreadCount chunks = sizes.threads(1);
    if (chunkSums_.count() < chunks.most()) {
        device.commands.finish(); // what was recorded may use those that are replaced
        chunkSums_ = {device.context, chunks.most(), "chunks of next rays"};
        chunkOffsets_ = {device.context, std::size_t{chunks.most()} + 1, "offsets of next rays"};
    }
    device.commands.run(
        sumChunks_,
        shared::SumChunksArguments{.values = alive, .sums = chunkSums_, .count = paths.most(), .live = paths.live()},
        chunks);
    prefixSum_.run(device, chunkSums_, chunkOffsets_, {.sizes = sizes, .level = 1});
}

void NextRays::list(Device& device, const gpu::Array<shared::uint>& alive, const QueueSizes& sizes,
                    std::uint32_t slotsOfPath, const gpu::Array<shared::uint>& slots) {
    const gpu::ThreadCount paths = sizes.threads();
    device.commands.run(listNextRays_,
                        shared::ListNextRaysArguments{.alive = alive,
                                                      .chunkOffsets = chunkOffsets_,
                                                      .slots = slots,
                                                      .count = paths.most(),
                                                      .slotsOfPath = slotsOfPath,
                                                      .room = static_cast<std::uint32_t>(slots.count()),
                                                      .live = paths.live()},
                        sizes.threads(1));
}

} // namespace hyalite::render
