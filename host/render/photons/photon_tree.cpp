#include "render/photons/photon_tree.h"

#include "base/error.h"

#include "shaders/shared/kd_tree.h"

#include <algorithm>
#include <string>
#include <utility>

namespace hyalite::render {

namespace {

using shared::kRadix;
using shared::kSortChunk;
using shared::kSplitChunk;
using shared::uint;

constexpr uint kDigitBits = 8;

// Subtrees of at most so many photons are finished by one thread each: 512 and 2048 measure alike.
constexpr uint kSubtreeSize = 512;

uint chunksOf(uint count, uint chunk) {
    return (count + chunk - 1) / chunk;
}

// Levels to split before every subtree is small; the leftmost of a level is the largest.
uint parallelLevels(uint photons) {
    uint levels = 0;
    while (shared::kdSubtree({0, photons}, levels, 0).count > kSubtreeSize) {
        ++levels;
    }
    return levels;
}

// The threads that part one level: by list, node and chunk.
uint sideThreads(uint photons, uint level) {
    return (3 * chunksOf(shared::kdSubtree({0, photons}, level, 0).count, kSplitChunk)) << level;
}

} // namespace

PhotonTree::PhotonTree(Device& device)
    : markPhotons_(device.kernel("mark_photons")), keyPhotons_(device.kernel("key_photons")),
      countDigits_(device.kernel("count_digits")), sortDigits_(device.kernel("sort_digits")),
      splitNodes_(device.kernel("split_nodes")), countSides_(device.kernel("count_sides")),
      partSides_(device.kernel("part_sides")), finishSubtrees_(device.kernel("finish_subtrees")),
      placePhotons_(device.kernel("place_photons")), prefixSum_(device), order_(device.context, 1, "tree order") {}

void PhotonTree::build(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots,
                       const gpu::Array<shared::Photon>& table, std::uint32_t base) {
    base_ = base;
    photonCount_ = 0;
    if (slots == 0) {
        return;
    }
    // The stored photons and the keys that they are sorted by
    listPhotons(device, photons, slots);
    if (std::size_t{base} + photonCount_ > table.count()) {
        throw Error(ExitCode::BadInput, "a photon table of " + std::to_string(table.count()) + " has no room for " +
                                            std::to_string(photonCount_) + " photons from " + std::to_string(base));
    }
    if (photonCount_ == 0) {
        return;
    }
    // Three lists of them, one along each axis
    sortAlongAxes(device);
    // Part the lists about the photon in the middle of each node's longest side, down to the leaves
    splitLevels(device);
    // And move the photons to their nodes
    const shared::PhotonArray tree{table.buffer().address() + base * sizeof(shared::Photon)};
    device.commands.run(placePhotons_,
                        shared::PlacePhotonsArguments{.photons = photons,
                                                      .nodes = nodes_,
                                                      .slots = slots_,
                                                      .sorted = tree,
                                                      .order = order_,
                                                      .count = photonCount_},
                        photonCount_);
}

void PhotonTree::listPhotons(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t slots) {
    if (marks_.count() < slots) {
        device.commands.finish();                                // what was recorded may use those that are replaced
        const std::size_t room = std::size_t{slots} + slots / 4; // passes differ a little
        marks_ = {device.context, room, "photon marks"};
        numbers_ = {device.context, room + 1, "photon numbers"};
    }
    device.commands.run(markPhotons_, shared::MarkPhotonsArguments{.photons = photons, .marks = marks_, .count = slots},
                        slots);
    prefixSum_.run(device, marks_, numbers_, slots);
    device.commands.finish();
    photonCount_ = numbers_.read(slots);
    reserve(device);
    device.commands.run(keyPhotons_,
                        shared::KeyPhotonsArguments{.photons = photons,
                                                    .numbers = numbers_,
                                                    .slots = slots_,
                                                    .keys = keys_,
                                                    .pairs = even_,
                                                    .count = slots,
                                                    .stored = photonCount_},
                        photonCount_ == 0 ? 0 : slots);
}

void PhotonTree::sortAlongAxes(Device& device) {
    const uint n = photonCount_;
    const uint threads = 3 * chunksOf(n, kSortChunk);
    shared::UintPairArray from{even_};
    shared::UintPairArray to{odd_};
    // The lowest digit first; each round keeps the order of equal digits, so that equal keys stay in slot order
    for (uint shift = 0; shift < 32; shift += kDigitBits) {
        const bool last = shift + kDigitBits == 32; // its pairs come from the odd array: the even one is free
        device.commands.run(countDigits_,
                            shared::CountDigitsArguments{
                                .pairs = from, .counts = counts_, .count = threads, .stored = n, .shift = shift},
                            threads);
        prefixSum_.run(device, counts_, sums_, threads * kRadix);
        device.commands.run(sortDigits_,
                            shared::SortDigitsArguments{.pairs = from,
                                                        .places = sums_,
                                                        .sorted = to,
                                                        .keys = keys_,
                                                        .lists = even_,
                                                        .count = threads,
                                                        .stored = n,
                                                        .shift = shift,
                                                        .last = last ? 1U : 0U},
                            threads);
        std::swap(from, to);
    }
}

void PhotonTree::splitLevels(Device& device) {
    gpu::Commands& commands = device.commands;
    const uint n = photonCount_;
    shared::KeyedPhotonArray lists{even_};
    shared::KeyedPhotonArray parted{odd_};
    const uint levels = parallelLevels(n);
    for (uint level = 0; level < levels; ++level) {
        const uint nodes = 1U << level;
        const uint threads = sideThreads(n, level);
        const uint chunks = threads / (3 * nodes);
        // The keys are in the lists by now: what splits each node takes their place
        commands.run(splitNodes_,
                     shared::SplitNodesArguments{
                         .lists = lists, .splits = keys_, .nodes = nodes_, .count = nodes, .level = level, .stored = n},
                     nodes);
        commands.run(countSides_,
                     shared::CountSidesArguments{.lists = lists,
                                                 .splits = keys_,
                                                 .nodes = nodes_,
                                                 .counts = counts_,
                                                 .count = threads,
                                                 .level = level,
                                                 .chunks = chunks,
                                                 .stored = n},
                     threads);
        prefixSum_.run(device, counts_, sums_, threads);
        commands.run(partSides_,
                     shared::PartSidesArguments{.lists = lists,
                                                .splits = keys_,
                                                .nodes = nodes_,
                                                .sums = sums_,
                                                .parted = parted,
                                                .count = threads,
                                                .level = level,
                                                .chunks = chunks,
                                                .stored = n},
                     threads);
        std::swap(lists, parted);
    }
    commands.run(
        finishSubtrees_,
        shared::FinishSubtreesArguments{
            .lists = lists, .others = parted, .nodes = nodes_, .count = 1U << levels, .level = levels, .stored = n},
        1U << levels);
}

void PhotonTree::reserve(Device& device) {
    const std::size_t n = photonCount_;
    std::size_t counters = std::size_t{3} * chunksOf(photonCount_, kSortChunk) * kRadix;
    for (uint level = 0; level < parallelLevels(photonCount_); ++level) {
        counters = std::max(counters, std::size_t{sideThreads(photonCount_, level)});
    }
    if (counts_.count() < counters) {
        counts_ = {device.context, counters + counters / 4, "tree counters"};
        sums_ = {device.context, counters + counters / 4 + 1, "tree offsets"};
    }
    if (keys_.count() < n) {
        const std::size_t room = n + n / 4;
        slots_ = {device.context, room, "tree slots"};
        keys_ = {device.context, room, "tree keys"};
        even_ = {device.context, 3 * room, "tree lists"};
        odd_ = {device.context, 3 * room, "tree lists"};
        nodes_ = {device.context, room, "tree nodes"};
        order_ = {device.context, room, "tree order"};
    }
}

} // namespace hyalite::render
