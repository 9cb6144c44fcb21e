#include "render/wavefront/next_rays.h"

namespace hyalite::render {

namespace {

std::uint32_t chunksOf(std::uint32_t paths) {
    return (paths + shared::kScanChunk - 1) / shared::kScanChunk;
}

} // namespace

NextRays::NextRays(const Device& device)
    : sumChunks_(device.kernel("sum_chunks")), listNextRays_(device.kernel("list_next_rays")), prefixSum_(device) {}

std::uint32_t NextRays::count(Device& device, const gpu::Array<shared::uint>& alive, std::uint32_t paths) {
    const std::uint32_t chunks = chunksOf(paths);
    if (chunkSums_.count() < chunks) {
        device.commands.finish(); // what was recorded may use those that are replaced
        chunkSums_ = {device.context, chunks, "chunks of next rays"};
        chunkOffsets_ = {device.context, std::size_t{chunks} + 1, "offsets of next rays"};
    }
    device.commands.run(sumChunks_, shared::SumChunksArguments{alive, chunkSums_, paths}, chunks);
    prefixSum_.run(device, chunkSums_, chunkOffsets_, chunks);
    device.commands.finish();
    return chunkOffsets_.host()[chunks];
}

void NextRays::list(Device& device, const gpu::Array<shared::uint>& alive, std::uint32_t paths,
                    std::uint32_t slotsOfPath, const gpu::Array<shared::uint>& slots) const {
    device.commands.run(listNextRays_, shared::ListNextRaysArguments{alive, chunkOffsets_, slots, paths, slotsOfPath},
                        chunksOf(paths));
}

} // namespace hyalite::render
