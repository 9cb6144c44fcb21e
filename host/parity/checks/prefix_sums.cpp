// Prefix sums: integers.
#include "parity/checks/checks.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <numeric>

namespace hyalite::parity {

namespace {

struct SumFields : FieldSet<1> {
    const Field& sum = exact("sum");
};
constexpr SumFields kSums;

struct QueueFields : FieldSet<1> {
    const Field& nextSize = exact("next size");
};
constexpr QueueFields kQueue;

// Exclusive sums, the total last; they begin anew with what precedes each chunk, where that is given.
void compareSums(const Stage& stage, std::span<const shared::uint> values, std::span<const shared::uint> sums,
                 std::span<const shared::uint> chunkOffsets) {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (!chunkOffsets.empty() && i < values.size() && i % shared::kScanChunk == 0) {
            sum = chunkOffsets[i / shared::kScanChunk];
        }
        Answer device;
        device.exact(kSums.sum, sums[i]);
        Answer expected;
        expected.exact(kSums.sum, sum);
        stage.compareExact(i, device, expected);
        sum += i < values.size() ? values[i] : 0;
    }
}

void compareScanGroup(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::ScanGroupArguments>();
    const auto values = stage.seen.before<shared::uint>(args.values, args.count);
    compareSums(stage, values, stage.seen.after<shared::uint>(args.sums, std::size_t{args.count} + 1), {});
    if (args.queue.address == 0) {
        return;
    }
    // What the queue will hold: the total of its flags
    const shared::QueueSize queue = stage.seen.before<shared::QueueSize>(args.queue, 1)[0];
    std::uint32_t count = std::accumulate(values.begin(), values.end(), 0U);
    for (const shared::QueueSize& next : stage.seen.after<shared::QueueSize>(args.next, shared::kQueueLevels)) {
        Answer device;
        device.exact(kQueue.nextSize, sameBits(next, shared::queueSize(count, queue.before + queue.count)) ? 1 : 0);
        Answer expected;
        expected.exact(kQueue.nextSize, 1);
        stage.compareExact(0, device, expected);
        count = shared::chunksOf(count);
    }
}

void compareSumChunks(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SumChunksArguments>();
    const auto values = stage.seen.before<shared::uint>(args.values, args.count);
    const std::size_t chunks = (args.count + shared::kScanChunk - 1) / shared::kScanChunk;
    const auto sums = stage.seen.after<shared::uint>(args.sums, chunks);
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        std::uint32_t sum = 0;
        for (const shared::uint value :
             values.subspan(chunk * shared::kScanChunk,
                            std::min<std::size_t>(shared::kScanChunk, args.count - chunk * shared::kScanChunk))) {
            sum += value;
        }
        Answer device;
        device.exact(kSums.sum, sums[chunk]);
        Answer expected;
        expected.exact(kSums.sum, sum);
        stage.compareExact(chunk, device, expected);
    }
}

void compareScanChunks(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::ScanChunksArguments>();
    const auto values = stage.seen.before<shared::uint>(args.values, args.count);
    const std::size_t chunks = (args.count + shared::kScanChunk - 1) / shared::kScanChunk;
    compareSums(stage, values, stage.seen.after<shared::uint>(args.sums, std::size_t{args.count} + 1),
                stage.seen.before<shared::uint>(args.chunkOffsets, chunks));
}

} // namespace

const Check kScanGroup{.kernel = "scan_group", .compare = compareScanGroup, .fields = {kSums.all(), kQueue.all()}};
const Check kSumChunks{.kernel = "sum_chunks", .compare = compareSumChunks, .fields = {kSums.all()}};
const Check kScanChunks{.kernel = "scan_chunks", .compare = compareScanChunks, .fields = {kSums.all()}};

} // namespace hyalite::parity
