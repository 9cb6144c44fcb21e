// Prefix sums of integers.
#include "parity/checks/checks.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

struct SumFields : FieldSet<1> {
    const Field& sum = exact("sum");
};
constexpr SumFields kSums;

// Exclusive prefix sums, with the total last. Where the sum preceding each chunk is given, each chunk starts from it.
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
    compareSums(stage, stage.seen.before<shared::uint>(args.values, args.count),
                stage.seen.after<shared::uint>(args.sums, std::size_t{args.count} + 1), {});
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

const Check kScanGroup{.kernel = "scan_group", .compare = compareScanGroup, .fields = {kSums.all()}};
const Check kSumChunks{.kernel = "sum_chunks", .compare = compareSumChunks, .fields = {kSums.all()}};
const Check kScanChunks{.kernel = "scan_chunks", .compare = compareScanChunks, .fields = {kSums.all()}};

} // namespace hyalite::parity
