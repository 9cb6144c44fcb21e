// Prefix sums and the compaction of queues: integers and copies.
#include "parity/twins.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

template <class Path, class Arguments>
void compareCompaction(const Stage& stage) {
    const auto args = stage.seen.arguments<Arguments>();
    const auto alive = stage.seen.before<shared::uint>(args.alive, args.count);
    const auto offsets = stage.seen.before<shared::uint>(args.offsets, args.count);
    const auto nextRays = stage.seen.before<shared::Ray>(args.nextRays, args.count);
    const auto nextPaths = stage.seen.before<Path>(args.nextPaths, args.count);
    const auto rays = stage.seen.after<shared::Ray>(args.rays, args.count);
    const auto paths = stage.seen.after<Path>(args.paths, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        if (alive[i] == 0) {
            continue;
        }
        const std::size_t to = offsets[i];
        Answer device;
        device.exact("ray", to < rays.size() && sameBits(rays[to], nextRays[i]) ? 1 : 0);
        device.exact("path", to < paths.size() && sameBits(paths[to], nextPaths[i]) ? 1 : 0);
        Answer expected;
        expected.exact("ray", 1);
        expected.exact("path", 1);
        stage.compareExact(i, device, expected);
    }
}

// Exclusive sums, the total last; they begin anew with what precedes each chunk, where that is given.
void compareSums(const Stage& stage, std::span<const shared::uint> values, std::span<const shared::uint> sums,
                 std::span<const shared::uint> chunkOffsets) {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (!chunkOffsets.empty() && i < values.size() && i % shared::kScanChunk == 0) {
            sum = chunkOffsets[i / shared::kScanChunk];
        }
        Answer device;
        device.exact("sum", sums[i]);
        Answer expected;
        expected.exact("sum", sum);
        stage.compareExact(i, device, expected);
        sum += i < values.size() ? values[i] : 0;
    }
}

} // namespace

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
        device.exact("sum", sums[chunk]);
        Answer expected;
        expected.exact("sum", sum);
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

void compareListNextRays(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::ListNextRaysArguments>();
    const auto alive = stage.seen.before<shared::uint>(args.alive, args.count);
    const auto slots = stage.seen.after<shared::uint>(args.slots, std::size_t{args.slotsOfPath} * args.count);
    std::size_t to = 0;
    for (std::uint32_t i = 0; i < args.count; ++i) {
        for (std::uint32_t child = 0; child < alive[i]; ++child, ++to) {
            Answer device;
            device.exact("slot", to < slots.size() ? slots[to] : shared::kNone);
            Answer expected;
            expected.exact("slot", args.slotsOfPath * i + child);
            stage.compareExact(to, device, expected);
        }
    }
}

void compareCompactCameraPaths(const Stage& stage) {
    compareCompaction<shared::CameraPath, shared::CompactCameraPathsArguments>(stage);
}

void compareCompactPhotonPaths(const Stage& stage) {
    compareCompaction<shared::PhotonPath, shared::CompactPhotonPathsArguments>(stage);
}

} // namespace hyalite::parity
