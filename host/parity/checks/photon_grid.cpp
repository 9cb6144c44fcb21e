// The photon grid: counting, listing, sorting and moving photons. A photon's bucket follows from one multiplication,
// which every device rounds identically, so all results are exact.
#include "parity/checks/checks.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <algorithm>

namespace hyalite::parity {

namespace {

struct CellFields : FieldSet<2> {
    const Field& count = exact("count");
    const Field& ranks = exact("ranks");
};
constexpr CellFields kCells;

struct SlotFields : FieldSet<1> {
    const Field& slot = exact("slot");
};
constexpr SlotFields kSlots;

struct PhotonFields : FieldSet<1> {
    const Field& photon = exact("photon");
};
constexpr PhotonFields kPhotons;

std::uint32_t bucketOf(const glm::vec3& position, const shared::GridRecord& grid) {
    const glm::vec3 cell = glm::clamp(glm::floor(position * grid.inverseCellSize), glm::vec3(-shared::kFarthestCell),
                                      glm::vec3(shared::kFarthestCell));
    return shared::cellBucket(glm::ivec3(cell), grid.bucketMask);
}

void compareCountCells(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::CountCellsArguments>();
    const auto photons = stage.seen.before<shared::Photon>(args.photons, args.count);
    const std::size_t buckets = std::size_t{args.grid.bucketMask} + 1;
    const auto before = stage.seen.before<shared::uint>(args.cellCounts, buckets);
    const auto counts = stage.seen.after<shared::uint>(args.cellCounts, buckets);
    const auto ranks = stage.seen.after<shared::uint>(args.ranks, args.count);
    std::vector<std::uint32_t> expected(before.begin(), before.end());
    std::vector<std::vector<std::uint32_t>> ranksOf(buckets);
    for (std::size_t i = 0; i < args.count; ++i) {
        if (photons[i].surface != shared::kNone) {
            const std::uint32_t bucket = bucketOf(photons[i].position, args.grid);
            ++expected[bucket];
            ranksOf[bucket].push_back(ranks[i]);
        }
    }
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        if (expected[bucket] == 0 && counts[bucket] == 0) {
            continue;
        }
        // Threads run in any order, but together their ranks continue from the previous count
        std::ranges::sort(ranksOf[bucket]);
        bool areDistinct = true;
        for (std::size_t k = 0; k < ranksOf[bucket].size(); ++k) {
            areDistinct = areDistinct && ranksOf[bucket][k] == before[bucket] + k;
        }
        Answer device;
        device.exact(kCells.count, counts[bucket]);
        device.exact(kCells.ranks, areDistinct ? 1 : 0);
        Answer answer;
        answer.exact(kCells.count, expected[bucket]);
        answer.exact(kCells.ranks, 1);
        stage.compareExact(bucket, device, answer);
    }
}

void compareFillCells(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::FillCellsArguments>();
    const auto photons = stage.seen.before<shared::Photon>(args.photons, args.count);
    const auto ranks = stage.seen.before<shared::uint>(args.ranks, args.count);
    const auto starts = stage.seen.before<shared::uint>(args.cellStarts, std::size_t{args.grid.bucketMask} + 1);
    const auto order = stage.seen.after<shared::uint>(args.order, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        if (photons[i].surface == shared::kNone) {
            continue;
        }
        const std::size_t place = std::size_t{starts[bucketOf(photons[i].position, args.grid)]} + ranks[i];
        Answer device;
        device.exact(kSlots.slot, place < order.size() ? order[place] : shared::kNone);
        Answer answer;
        answer.exact(kSlots.slot, i);
        stage.compareExact(i, device, answer);
    }
}

void compareOrderCells(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::OrderCellsArguments>();
    const auto starts = stage.seen.before<shared::uint>(args.cellStarts, std::size_t{args.count} + 1);
    const auto before = stage.seen.before<shared::uint>(args.order, starts[args.count]);
    const auto order = stage.seen.after<shared::uint>(args.order, starts[args.count]);
    std::vector<std::uint32_t> expected(before.begin(), before.end());
    for (std::size_t bucket = 0; bucket < args.count; ++bucket) {
        // Treat buckets whose starts are out of order (a fault) as empty
        const std::size_t end = std::min<std::size_t>(starts[bucket + 1], expected.size());
        const std::size_t begin = std::min<std::size_t>(starts[bucket], end);
        std::ranges::sort(std::span(expected).subspan(begin, end - begin));
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
        Answer device;
        device.exact(kSlots.slot, order[i]);
        Answer answer;
        answer.exact(kSlots.slot, expected[i]);
        stage.compareExact(i, device, answer);
    }
}

void compareSortPhotons(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SortPhotonsArguments>();
    const auto order = stage.seen.before<shared::uint>(args.order, args.count);
    const auto photons = stage.seen.before<shared::Photon>(args.photons, Observed::kWhole);
    const auto sorted = stage.seen.after<shared::Photon>(args.sorted, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        Answer device;
        device.exact(kPhotons.photon, sameBits(sorted[i], photons[order[i]]) ? 1 : 0);
        Answer answer;
        answer.exact(kPhotons.photon, 1);
        stage.compareExact(i, device, answer);
    }
}

} // namespace

const Check kCountCells{.kernel = "count_cells", .compare = compareCountCells, .fields = {kCells.all()}};
const Check kFillCells{.kernel = "fill_cells", .compare = compareFillCells, .fields = {kSlots.all()}};
const Check kOrderCells{.kernel = "order_cells", .compare = compareOrderCells, .fields = {kSlots.all()}};
const Check kSortPhotons{.kernel = "sort_photons", .compare = compareSortPhotons, .fields = {kPhotons.all()}};

} // namespace hyalite::parity
