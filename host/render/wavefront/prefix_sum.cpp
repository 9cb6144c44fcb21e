#include "render/wavefront/prefix_sum.h"

namespace hyalite::render {

namespace {

// Up to so many values one workgroup is faster than all in turn: measured on lavapipe.
constexpr std::uint32_t kFewValues = 16384;

} // namespace

PrefixSum::PrefixSum(Device& device)
    : scanGroup_(device.kernel("scan_group")), sumChunks_(device.kernel("sum_chunks")),
      scanChunks_(device.kernel("scan_chunks")) {}

gpu::ThreadCount PrefixSum::Counts::at(std::uint32_t level) const {
    if (queue != nullptr) {
        return queue->sizes.threads(queue->level + level);
    }
    std::uint32_t values = count;
    for (std::uint32_t i = 0; i < level; ++i) {
        values = shared::chunksOf(values);
    }
    return values;
}

void PrefixSum::run(Device& device, const gpu::Array<shared::uint>& values, const gpu::Array<shared::uint>& sums,
                    std::uint32_t count) {
    const Counts counts{.queue = nullptr, .count = count};
    reserve(device, counts);
    scan(device, values, sums, counts, 0);
}

void PrefixSum::run(Device& device, const gpu::Array<shared::uint>& values, const gpu::Array<shared::uint>& sums,
                    const OfQueue& queue) {
    const Counts counts{.queue = &queue, .count = 0};
    reserve(device, counts);
    scan(device, values, sums, counts, 0);
}

// Room for every level first: buffers in use by recorded commands must not be replaced.
void PrefixSum::reserve(Device& device, const Counts& counts) {
    for (std::uint32_t level = 0; counts.at(level).most() > kFewValues; ++level) {
        const std::uint32_t chunks = counts.at(level + 1).most();
        if (level == levels_.size()) {
            levels_.emplace_back();
        }
        if (levels_[level].sums.count() < chunks) {
            device.commands.finish();
            levels_[level] = {.sums = {device.context, chunks, "chunk sums"},
                              .offsets = {device.context, std::size_t{chunks} + 1, "chunk offsets"}};
        }
    }
}

void PrefixSum::scan(Device& device, shared::UintArray values, shared::UintArray sums, const Counts& counts,
                     std::uint32_t level) {
    const gpu::ThreadCount count = counts.at(level);
    if (count.most() <= kFewValues) {
        const OfQueue* queue = counts.queue;
        device.commands.run(
            scanGroup_,
            shared::ScanGroupArguments{.values = values,
                                       .sums = sums,
                                       .count = count.most(),
                                       .live = count.live(),
                                       .queue = queue != nullptr ? queue->sizes.current() : shared::QueueSizeArray{},
                                       .next = queue != nullptr ? queue->sizes.next() : shared::QueueSizeArray{},
                                       .elementCount = queue != nullptr ? queue->elementCount : shared::UintArray{}},
            shared::kGroupSize);
        return;
    }
    const gpu::ThreadCount chunks = counts.at(level + 1);
    const Level& l = levels_[level];
    device.commands.run(
        sumChunks_,
        shared::SumChunksArguments{.values = values, .sums = l.sums, .count = count.most(), .live = count.live()},
        chunks);
    scan(device, l.sums, l.offsets, counts, level + 1);
    device.commands.run(
        scanChunks_,
        shared::ScanChunksArguments{
            .values = values, .chunkOffsets = l.offsets, .sums = sums, .count = count.most(), .live = count.live()},
        chunks);
}

} // namespace hyalite::render
