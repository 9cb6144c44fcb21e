// Queues without gaps: copies.
#include "parity/checks/checks.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <array>

namespace hyalite::parity {

namespace {

struct SlotFields : FieldSet<1> {
    const Field& slot = exact("slot");
};
constexpr SlotFields kSlots;

struct PathFields : FieldSet<2> {
    const Field& ray = exact("ray");
    const Field& path = exact("path");
};
constexpr PathFields kPaths;

void compareCompactPaths(const Stage& stage) {
    using Path = std::array<shared::uint, shared::kPathWords>;
    const auto args = stage.seen.arguments<shared::CompactPathsArguments>();
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
        device.exact(kPaths.ray, to < rays.size() && sameBits(rays[to], nextRays[i]) ? 1 : 0);
        device.exact(kPaths.path, to < paths.size() && sameBits(paths[to], nextPaths[i]) ? 1 : 0);
        Answer expected;
        expected.exact(kPaths.ray, 1);
        expected.exact(kPaths.path, 1);
        stage.compareExact(i, device, expected);
    }
}

void compareListNextRays(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::ListNextRaysArguments>();
    const auto alive = stage.seen.before<shared::uint>(args.alive, args.count);
    const auto slots = stage.seen.after<shared::uint>(args.slots, std::size_t{args.slotsOfPath} * args.count);
    std::size_t to = 0;
    for (std::uint32_t i = 0; i < args.count; ++i) {
        for (std::uint32_t child = 0; child < alive[i] && to < args.room; ++child, ++to) {
            Answer device;
            device.exact(kSlots.slot, to < slots.size() ? slots[to] : shared::kNone);
            Answer expected;
            expected.exact(kSlots.slot, args.slotsOfPath * i + child);
            stage.compareExact(to, device, expected);
        }
    }
}

} // namespace

const Check kListNextRays{.kernel = "list_next_rays", .compare = compareListNextRays, .fields = {kSlots.all()}};
const Check kCompactPaths{.kernel = "compact_paths", .compare = compareCompactPaths, .fields = {kPaths.all()}};

} // namespace hyalite::parity
