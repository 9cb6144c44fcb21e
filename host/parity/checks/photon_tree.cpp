// Building the kd-tree of photons [Jensen01], list by list and level by level: only integers and comparisons of floats.
#include "parity/checks/checks.h"

#include "shaders/shared/kd_tree.h"
#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <algorithm>
#include <bit>

namespace hyalite::parity {

namespace {

using shared::KdRange;
using shared::KeyedPhoton;
using shared::uint;

struct MarkFields : FieldSet<1> {
    const Field& mark = exact("mark");
};
constexpr MarkFields kMarks;

struct KeyFields : FieldSet<3> {
    const Field& slot = exact("slot");
    const Field& number = exact("number");
    const Field& keys = exact("keys");
};
constexpr KeyFields kKeys;

struct CountFields : FieldSet<1> {
    const Field& count = exact("count");
};
constexpr CountFields kCounts;

struct PhotonFields : FieldSet<1> {
    const Field& photon = exact("photon");
};
constexpr PhotonFields kPhotons;

struct SplitFields : FieldSet<2> {
    const Field& node = exact("node");
    const Field& photon = exact("photon");
};
constexpr SplitFields kSplits;

struct NodeFields : FieldSet<1> {
    const Field& node = exact("node");
};
constexpr NodeFields kNodes;

struct PlaceFields : FieldSet<2> {
    const Field& slot = exact("slot");
    const Field& photon = exact("photon");
};
constexpr PlaceFields kPlaces;

uint orderedBits(float x) {
    const uint bits = x == 0 ? 0 : std::bit_cast<uint>(x);
    return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}

float fromOrderedBits(uint bits) {
    return std::bit_cast<float>((bits & 0x80000000U) != 0 ? bits & 0x7fffffffU : ~bits);
}

bool isLess(const KeyedPhoton& a, const KeyedPhoton& b, int axis) {
    return std::pair(a.key[axis], a.photon) < std::pair(b.key[axis], b.photon);
}

// Three lists of `stored` photons, one sorted along each axis.
class Lists {
public:
    Lists(std::span<const KeyedPhoton> photons, std::size_t stored)
        : photons_(photons.begin(), photons.end()), stored_(stored) {}

    [[nodiscard]] std::span<KeyedPhoton> list(int axis, const KdRange& range) {
        return std::span(photons_).subspan(static_cast<std::size_t>(axis) * stored_ + range.first, range.count);
    }
    struct Split {
        int axis = 0;
        KeyedPhoton middle{};
        [[nodiscard]] uint word() const { return middle.photon | static_cast<uint>(axis) << shared::kSplitAxisShift; }
    };
    // Splits along the longest edge of the bounding box of the node's photons, the first of equal ones.
    [[nodiscard]] Split split(const KdRange& range) {
        Split chosen;
        float longest = -1;
        for (int axis = 0; axis < 3; ++axis) {
            const auto photons = list(axis, range);
            const float edge = fromOrderedBits(photons.back().key[axis]) - fromOrderedBits(photons.front().key[axis]);
            if (edge > longest) {
                longest = edge;
                chosen.axis = axis;
            }
        }
        chosen.middle = list(chosen.axis, range)[shared::kdLeftCount(range.count)];
        return chosen;
    }
    // Partitions into left child, median (unchanged) and right child, each in stable order.
    void part(const KdRange& range, const Split& split) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto photons = list(axis, range);
            std::vector<KeyedPhoton> right;
            std::size_t left = 0;
            for (const KeyedPhoton& photon : std::vector<KeyedPhoton>(photons.begin(), photons.end())) {
                if (photon.photon == split.middle.photon) {
                    continue;
                }
                if (isLess(photon, split.middle, split.axis)) {
                    photons[left++] = photon;
                } else {
                    right.push_back(photon);
                }
            }
            std::ranges::copy(right, photons.begin() + static_cast<std::ptrdiff_t>(left + 1));
        }
    }

private:
    std::vector<KeyedPhoton> photons_;
    std::size_t stored_;
};

void compareMarkPhotons(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::MarkPhotonsArguments>();
    const auto photons = stage.seen.before<shared::Photon>(args.photons, args.count);
    const auto marks = stage.seen.after<uint>(args.marks, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        stage.expect(i, kMarks.mark, marks[i], photons[i].surface == shared::kNone ? 0 : 1);
    }
}

void compareKeyPhotons(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::KeyPhotonsArguments>();
    const auto photons = stage.seen.before<shared::Photon>(args.photons, args.count);
    const auto numbers = stage.seen.before<uint>(args.numbers, args.count);
    const auto slots = stage.seen.after<uint>(args.slots, args.stored);
    const auto keys = stage.seen.after<KeyedPhoton>(args.keys, args.stored);
    const auto pairs = stage.seen.after<glm::uvec2>(args.pairs, std::size_t{3} * args.stored);
    for (std::size_t i = 0; i < args.count; ++i) {
        if (photons[i].surface == shared::kNone) {
            continue;
        }
        const uint number = numbers[i];
        Answer device;
        Answer answer;
        device.exact(kKeys.slot, slots[number]);
        answer.exact(kKeys.slot, i);
        device.exact(kKeys.number, keys[number].photon);
        answer.exact(kKeys.number, number);
        bool keysAgree = true;
        for (uint axis = 0; axis < 3; ++axis) {
            const uint key = orderedBits(photons[i].position[static_cast<int>(axis)]);
            keysAgree = keysAgree && keys[number].key[static_cast<int>(axis)] == key &&
                        pairs[axis * args.stored + number] == glm::uvec2(key, number);
        }
        device.exact(kKeys.keys, keysAgree ? 1 : 0);
        answer.exact(kKeys.keys, 1);
        stage.compareExact(i, device, answer);
    }
}

void compareCountDigits(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::CountDigitsArguments>();
    const std::size_t chunks = args.count / 3;
    const auto pairs = stage.seen.before<glm::uvec2>(args.pairs, std::size_t{3} * args.stored);
    const auto counts = stage.seen.after<uint>(args.counts, std::size_t{3} * shared::kRadix * chunks);
    std::vector<uint> expected(counts.size(), 0);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const std::size_t axis = i / args.stored;
        const std::size_t chunk = i % args.stored / shared::kSortChunk;
        const uint digit = pairs[i].x >> args.shift & (shared::kRadix - 1);
        ++expected[(axis * shared::kRadix + digit) * chunks + chunk];
    }
    for (std::size_t i = 0; i < counts.size(); ++i) {
        stage.expect(i, kCounts.count, counts[i], expected[i]);
    }
}

void compareSortDigits(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SortDigitsArguments>();
    const auto pairs = stage.seen.before<glm::uvec2>(args.pairs, std::size_t{3} * args.stored);
    const auto keys = stage.seen.before<KeyedPhoton>(args.keys, args.stored);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto list = pairs.subspan(axis * args.stored, args.stored);
        std::vector<glm::uvec2> expected(list.begin(), list.end());
        const auto digit = [&](const glm::uvec2& pair) { return pair.x >> args.shift & (shared::kRadix - 1); };
        std::ranges::stable_sort(expected, {}, digit);
        const auto sorted = stage.seen.after<glm::uvec2>(args.sorted, std::size_t{3} * args.stored);
        const auto lists = stage.seen.after<KeyedPhoton>(args.lists, std::size_t{3} * args.stored);
        for (std::size_t i = 0; i < args.stored; ++i) {
            const std::size_t at = axis * args.stored + i;
            const bool agrees = args.last == 0 ? sorted[at] == expected[i] : sameBits(lists[at], keys[expected[i].y]);
            stage.expect(at, kPhotons.photon, agrees ? 1 : 0, 1);
        }
    }
}

void compareSplitNodes(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SplitNodesArguments>();
    Lists lists(stage.seen.before<KeyedPhoton>(args.lists, std::size_t{3} * args.stored), args.stored);
    const auto splits = stage.seen.after<KeyedPhoton>(args.splits, args.count);
    const auto nodes = stage.seen.after<uint>(args.nodes, 2 * std::size_t{args.count} - 1);
    for (uint node = 0; node < args.count; ++node) {
        const auto split = lists.split(shared::kdSubtree({0, args.stored}, args.level, node));
        Answer device;
        device.exact(kSplits.node, nodes[args.count - 1 + node]);
        device.exact(kSplits.photon, splits[node].photon);
        Answer answer;
        answer.exact(kSplits.node, split.word());
        answer.exact(kSplits.photon, split.middle.photon);
        stage.compareExact(node, device, answer);
    }
}

void compareCountSides(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::CountSidesArguments>();
    Lists lists(stage.seen.before<KeyedPhoton>(args.lists, std::size_t{3} * args.stored), args.stored);
    const auto counts = stage.seen.after<uint>(args.counts, args.count);
    for (uint i = 0; i < args.count; ++i) {
        const uint chunk = i % args.chunks;
        const KdRange range =
            shared::kdSubtree({0, args.stored}, args.level, i / args.chunks & ((1U << args.level) - 1));
        const auto split = lists.split(range);
        const auto photons = lists.list(static_cast<int>((i / args.chunks) >> args.level), range);
        const std::size_t begin = std::min<std::size_t>(std::size_t{chunk} * shared::kSplitChunk, photons.size());
        const std::size_t end = std::min<std::size_t>(begin + shared::kSplitChunk, photons.size());
        const auto expected = std::ranges::count_if(photons.subspan(begin, end - begin), [&](const KeyedPhoton& p) {
            return isLess(p, split.middle, split.axis);
        });
        stage.expect(i, kCounts.count, counts[i], static_cast<std::uint64_t>(expected));
    }
}

void comparePartSides(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::PartSidesArguments>();
    Lists lists(stage.seen.before<KeyedPhoton>(args.lists, std::size_t{3} * args.stored), args.stored);
    Lists parted(stage.seen.after<KeyedPhoton>(args.parted, std::size_t{3} * args.stored), args.stored);
    for (uint node = 0; node < 1U << args.level; ++node) {
        const KdRange range = shared::kdSubtree({0, args.stored}, args.level, node);
        lists.part(range, lists.split(range));
        for (int axis = 0; axis < 3; ++axis) {
            const auto expected = lists.list(axis, range);
            const auto found = parted.list(axis, range);
            for (uint i = 0; i < range.count; ++i) {
                if (i != shared::kdLeftCount(range.count)) {
                    stage.expect(std::size_t{range.first} + i, kPhotons.photon, found[i].photon, expected[i].photon);
                }
            }
        }
    }
}

void compareFinishSubtrees(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::FinishSubtreesArguments>();
    Lists lists(stage.seen.before<KeyedPhoton>(args.lists, std::size_t{3} * args.stored), args.stored);
    const auto nodes = stage.seen.after<uint>(args.nodes, args.stored);
    struct Subtree {
        std::size_t node; // in heap order
        KdRange range;
    };
    std::vector<Subtree> open;
    for (uint number = 0; number < args.count; ++number) {
        open.push_back({std::size_t{args.count} - 1 + number, shared::kdSubtree({0, args.stored}, args.level, number)});
    }
    while (!open.empty()) {
        const auto [node, range] = open.back();
        open.pop_back();
        if (range.count == 0) {
            continue;
        }
        const auto split = lists.split(range);
        stage.expect(node, kNodes.node, node < nodes.size() ? nodes[node] : shared::kNone, split.word());
        lists.part(range, split);
        open.push_back({2 * node + 1, shared::kdSubtree(range, 1, 0)});
        open.push_back({2 * node + 2, shared::kdSubtree(range, 1, 1)});
    }
}

void comparePlacePhotons(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::PlacePhotonsArguments>();
    const auto photons = stage.seen.before<shared::Photon>(args.photons, Observed::kWhole);
    const auto nodes = stage.seen.before<uint>(args.nodes, args.count);
    const auto slots = stage.seen.before<uint>(args.slots, args.count);
    const auto sorted = stage.seen.after<shared::Photon>(args.sorted, args.count);
    const auto order = stage.seen.after<uint>(args.order, args.count);
    const uint axisMask = 3U << shared::kSplitAxisShift;
    for (std::size_t i = 0; i < args.count; ++i) {
        const uint slot = slots[nodes[i] & ~axisMask];
        shared::Photon expected = photons[slot];
        expected.direction = (expected.direction & ~axisMask) | (nodes[i] & axisMask);
        Answer device;
        device.exact(kPlaces.slot, order[i]);
        device.exact(kPlaces.photon, sameBits(sorted[i], expected) ? 1 : 0);
        Answer answer;
        answer.exact(kPlaces.slot, slot);
        answer.exact(kPlaces.photon, 1);
        stage.compareExact(i, device, answer);
    }
}

} // namespace

const Check kMarkPhotons{.kernel = "mark_photons", .compare = compareMarkPhotons, .fields = {kMarks.all()}};
const Check kKeyPhotons{.kernel = "key_photons", .compare = compareKeyPhotons, .fields = {kKeys.all()}};
const Check kCountDigits{.kernel = "count_digits", .compare = compareCountDigits, .fields = {kCounts.all()}};
const Check kSortDigits{.kernel = "sort_digits", .compare = compareSortDigits, .fields = {kPhotons.all()}};
const Check kSplitNodes{.kernel = "split_nodes", .compare = compareSplitNodes, .fields = {kSplits.all()}};
const Check kCountSides{.kernel = "count_sides", .compare = compareCountSides, .fields = {kCounts.all()}};
const Check kPartSides{.kernel = "part_sides", .compare = comparePartSides, .fields = {kPhotons.all()}};
const Check kFinishSubtrees{.kernel = "finish_subtrees", .compare = compareFinishSubtrees, .fields = {kNodes.all()}};
const Check kPlacePhotons{.kernel = "place_photons", .compare = comparePlacePhotons, .fields = {kPlaces.all()}};

} // namespace hyalite::parity
