#include "render/photons/photon_grid.h"

#include "base/error.h"

#include <algorithm>
#include <bit>
#include <string>

namespace hyalite::render {

namespace {

// Narrower cells bring fewer photons that lie beyond the radius, but more rows to look up: where some thirty photons
// are found, searches took 1.6 times as long with 2/3 of a radius, 1.2 with 1, 1.1 with 5/2, 1.25 with 3. A little more
// than two, so that a search reaches into two cells along each axis and never three.
constexpr float kCellSize = 2.004F; // [search radii]

constexpr std::uint32_t kLeastBuckets = 1U << 10;

} // namespace

PhotonGrid::PhotonGrid(Device& device)
    : countCells_(device.kernel("count_cells")), fillCells_(device.kernel("fill_cells")),
      orderCells_(device.kernel("order_cells")), sortPhotons_(device.kernel("sort_photons")), prefixSum_(device) {
    reserve(device, 1);
}

void PhotonGrid::reserve(Device& device, std::uint32_t slots) {
    // One bucket for every two slots: about half of the slots hold a photon
    const std::uint32_t buckets = std::max(kLeastBuckets, std::bit_ceil(slots / 2));
    if (cellCounts_.count() < buckets || ranks_.count() < slots) {
        device.commands.finish(); // what was recorded may use those that are replaced
    }
    if (cellCounts_.count() < buckets) {
        cellCounts_ = {device.context, buckets, "photons per cell"};
        cellStarts_ = {device.context, buckets + std::size_t{1}, "cell starts"};
    }
    if (ranks_.count() < slots) {
        const std::size_t room = std::size_t{slots} + slots / 4; // passes differ a little
        ranks_ = {device.context, room, "photon ranks"};
        order_ = {device.context, room, "photon order"};
    }
    grid_.bucketMask = buckets - 1;
}

void PhotonGrid::build(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots, float radius) {
    listByCell(device, photons, slots, radius);
    if (sorted_.count() < photonCount_) {
        sorted_ = {device.context, std::size_t{photonCount_} + photonCount_ / 4,
                   "sorted photons"}; // passes differ a little
        device.tables.set(TABLE_PHOTONS, sorted_.buffer(), gpu::TexelFormat::Float4);
    }
    base_ = 0;
    device.commands.run(
        sortPhotons_,
        shared::SortPhotonsArguments{.photons = photons, .order = order_, .sorted = sorted_, .count = photonCount_},
        photonCount_);
}

void PhotonGrid::build(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots, float radius,
                       const gpu::Array<shared::Photon>& table, std::uint32_t base) {
    listByCell(device, photons, slots, radius);
    if (std::size_t{base} + photonCount_ > table.count()) {
        throw Error(ExitCode::BadInput, "a photon table of " + std::to_string(table.count()) + " has no room for " +
                                            std::to_string(photonCount_) + " photons from " + std::to_string(base));
    }
    base_ = base;
    const shared::PhotonArray sorted{table.buffer().address() + base * sizeof(shared::Photon)};
    device.commands.run(
        sortPhotons_,
        shared::SortPhotonsArguments{.photons = photons, .order = order_, .sorted = sorted, .count = photonCount_},
        photonCount_);
}

void PhotonGrid::listByCell(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots,
                            float radius) {
    reserve(device, slots);
    grid_.inverseCellSize = 1 / (kCellSize * radius);
    const std::uint32_t buckets = grid_.bucketMask + 1;

    // How many photons fall into each bucket, and where each bucket's photons begin
    device.commands.clear(cellCounts_.buffer());
    device.commands.run(
        countCells_,
        shared::CountCellsArguments{
            .photons = photons, .cellCounts = cellCounts_, .ranks = ranks_, .grid = grid_, .count = slots},
        slots);
    prefixSum_.run(device, cellCounts_, cellStarts_, buckets);
    // List them bucket by bucket, in the order in which they were emitted
    device.commands.run(fillCells_,
                        shared::FillCellsArguments{.photons = photons,
                                                   .cellStarts = cellStarts_,
                                                   .ranks = ranks_,
                                                   .order = order_,
                                                   .grid = grid_,
                                                   .count = slots},
                        slots);
    device.commands.run(orderCells_,
                        shared::OrderCellsArguments{.cellStarts = cellStarts_, .order = order_, .count = buckets},
                        buckets);
    device.commands.finish();
    photonCount_ = cellStarts_.read(buckets);
}

} // namespace hyalite::render
