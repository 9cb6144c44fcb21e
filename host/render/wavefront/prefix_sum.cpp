#include "render/wavefront/prefix_sum.h"

namespace hyalite::render {

using shared::kScanChunk;

namespace {

// Up to so many values one workgroup is faster than all in turn: measured on lavapipe.
constexpr std::uint32_t kFewValues = 16384;

} // namespace

PrefixSum::PrefixSum(const Device& device)
    : scanGroup_(device.kernel("scan_group")), sumChunks_(device.kernel("sum_chunks")),
      scanChunks_(device.kernel("scan_chunks")) {}

void PrefixSum::run(Device& device, const gpu::Array<shared::uint>& values, const gpu::Array<shared::uint>& sums,
                    std::uint32_t count) {
    // Room for every level first: buffers in use by recorded commands must not be replaced
    std::size_t level = 0;
    for (std::uint32_t n = count; n > kFewValues; ++level) {
        n = (n + kScanChunk - 1) / kScanChunk;
        if (level == levels_.size()) {
            levels_.emplace_back();
        }
        if (levels_[level].sums.count() < n) {
            device.commands.finish();
            levels_[level] = {{device.context, n, "chunk sums"}, {device.context, n + 1, "chunk offsets"}};
        }
    }
    scan(device, values, sums, count, 0);
}

void PrefixSum::scan(Device& device, shared::UintArray values, shared::UintArray sums, std::uint32_t count,
                     std::size_t level) {
    if (count <= kFewValues) {
        device.commands.run(scanGroup_, shared::ScanGroupArguments{values, sums, count}, shared::kGroupSize);
        return;
    }
    const std::uint32_t chunks = (count + kScanChunk - 1) / kScanChunk;
    const Level& l = levels_[level];
    device.commands.run(sumChunks_, shared::SumChunksArguments{values, l.sums, count}, chunks);
    scan(device, l.sums, l.offsets, chunks, level + 1);
    device.commands.run(scanChunks_, shared::ScanChunksArguments{values, l.offsets, sums, count}, chunks);
}

} // namespace hyalite::render
