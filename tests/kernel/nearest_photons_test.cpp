// The nearest photons that the kernels find in trees and grids, against a brute-force search.
#include "kernel/photon_sets.h"
#include "render/photons/photon_grid.h"
#include "render/photons/photon_query.h"
#include "render/photons/photon_tree.h"

#include <algorithm>

namespace hyalite::testing {

namespace {

constexpr std::uint32_t kPhotons = 6000;
constexpr std::uint32_t kQueries = 850; // 8 sets, 3 radii, 5 numbers of photons: 102 000 in all
constexpr std::uint32_t kKinds = 1U << shared::kPhotonIndirect | 1U << shared::kPhotonCaustic;
constexpr std::uint32_t kMaxDepth = 5;
constexpr std::uint32_t kDown = 0; // octahedral (-1, -1) is (0, 0, -1), at any number of bits

// Slots that hold photons of every kind, length and side, and what makes each count.
struct MixedPhotons {
    std::vector<shared::Photon> slots;
    std::vector<bool> sameSurface; // it landed on an upward one …
    std::vector<bool> sameSide;    // … from above, and is of a kind that is asked for
    std::vector<std::uint32_t> length;
};

MixedPhotons mixed(const PhotonSet& set) {
    MixedPhotons photons{.slots = slotsOf(set), .sameSurface = {}, .sameSide = {}, .length = {}};
    for (std::uint32_t slot = 0; slot < photons.slots.size(); ++slot) {
        shared::Photon& photon = photons.slots[slot];
        const std::uint32_t die = shared::hash(slot);
        const bool stored = photon.surface != shared::kNone;
        const std::uint32_t kind = die % 8 == 0 ? shared::kPhotonShadow : die % 3;
        const bool downward = die / 8 % 8 == 0;
        const bool fromBelow = downward || die / 64 % 8 == 0;
        // A direct photon has its light where others have their length
        const std::uint32_t length =
            kind == shared::kPhotonDirect || kind == shared::kPhotonShadow ? 77 : 2 + die / 512 % 3;
        if (stored) {
            const std::uint32_t normal = downward ? kDown : photon.surface & ((1U << shared::kKindShift) - 1);
            photon.surface = normal | kind << shared::kKindShift | length << shared::kLengthShift;
            photon.direction = fromBelow ? kDown : photon.direction;
        }
        photons.sameSurface.push_back(stored && !downward);
        photons.sameSide.push_back(stored && !fromBelow && (kKinds >> kind & 1U) != 0);
        photons.length.push_back(length);
    }
    return photons;
}

// As the kernels compute it.
float distance2(const vec3& a, const vec3& b) {
    const vec3 way = a - b;
    return way.x * way.x + way.y * way.y + way.z * way.z;
}

// Slots of the nearest, by distance and slot, then kNone.
std::vector<std::uint32_t> askEvery(const MixedPhotons& photons, const shared::VisiblePoint& x, std::uint32_t nearest,
                                    float radius) {
    std::vector<std::pair<float, std::uint32_t>> found;
    for (std::uint32_t slot = 0; slot < photons.slots.size(); ++slot) {
        const float d2 = distance2(photons.slots[slot].position, x.position);
        if (photons.sameSide[slot] && d2 <= radius * radius && photons.length[slot] + x.depth <= kMaxDepth) {
            found.emplace_back(d2, slot);
        }
    }
    const std::size_t count = std::min<std::size_t>(nearest, found.size());
    std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), found.end());
    std::vector<std::uint32_t> slots(nearest, shared::kNone);
    for (std::size_t i = 0; i < count; ++i) {
        slots[i] = found[i].second;
    }
    return slots;
}

std::vector<shared::VisiblePoint> queriesNear(const PhotonSet& set, double spread, reference::test::Random& random) {
    std::vector<shared::VisiblePoint> points;
    for (std::uint32_t i = 0; i < kQueries; ++i) {
        dvec3 at = random.inCube(1.1);
        if (!set.positions.empty() && i % 4 != 0) { // at a photon, near one, anywhere
            at = dvec3(set.positions[std::size_t{7} * i % set.positions.size()]) +
                 (i % 4 == 1 ? 0.0 : spread) * random.inCube(1);
        }
        shared::VisiblePoint x{};
        x.position = vec3(at);
        x.normal = {0, 0, 1};
        x.geometricNormal = 0x7fffU | 0x7fffU << 16U; // +z
        x.depth = i % 50 == 0 ? 0 : 1 + i % 3;
        points.push_back(x);
    }
    return points;
}

struct Maps {
    render::PhotonTree tree;
    render::PhotonGrid grid;
    gpu::Array<shared::Photon> table; // the tree, then the grid

    Maps(BothSides& both, const std::vector<shared::Photon>& slots, float radius)
        : tree(both.device), grid(both.device), table(both.room<shared::Photon>(2 * slots.size() + 3)) {
        const auto deviceSlots = both.upload(slots);
        const auto count = static_cast<std::uint32_t>(slots.size());
        tree.build(both.device, deviceSlots, count, table, 3);
        grid.build(both.device, deviceSlots, count, radius, table, 3 + tree.photonCount());
        both.device.commands.finish();
        both.device.tables.set(TABLE_PHOTONS, table.buffer(), gpu::TexelFormat::Float4);
    }
};

} // namespace

TEST_CASE("tree and grid find exactly the photons of a brute-force search, in order of distance") {
    BothSides both(reference::test::cornellBox());
    reference::test::Random random;
    for (const PhotonSet& set : hardPhotonSets(kPhotons)) {
        const MixedPhotons photons = mixed(set);
        for (const float radius : {0.05F, 0.4F, 4.0F}) {
            const Maps maps(both, photons.slots, radius);
            for (const std::uint32_t nearest : {1U, 2U, 50U, 200U, 512U}) {
                INFO(set.name << ", radius " << radius << ", " << nearest << " photons");
                const auto points = queriesNear(set, 0.5 * radius, random);
                const auto devicePoints = both.upload(points);
                const auto found = both.room<shared::uint>(std::size_t{kQueries} * nearest);
                // Positions off their surface by any distance: no photon is on another one
                const render::PhotonSearch search{
                    .nearest = nearest, .radius = radius, .kinds = kKinds, .maxDepth = kMaxDepth, .surfaceError = 100};
                std::vector<std::uint32_t> answers[2];
                for (const auto structure : {render::PhotonStructure::Tree, render::PhotonStructure::Grid}) {
                    const bool isTree = structure == render::PhotonStructure::Tree;
                    render::NearestPhotons query(both.device, structure, nearest);
                    query.run(both.device, isTree ? maps.tree.map() : maps.grid.map(), devicePoints, kQueries, search,
                              found);
                    both.device.commands.finish();
                    answers[isTree ? 0 : 1] = found.read();
                }
                REQUIRE(answers[0] == answers[1]);
                std::size_t wrong = 0;
                for (std::uint32_t i = 0; i < kQueries; ++i) {
                    auto expected = points[i].depth == 0 ? std::vector<std::uint32_t>(nearest, shared::kNone)
                                                         : askEvery(photons, points[i], nearest, radius);
                    const auto* actual = answers[0].data() + std::size_t{i} * nearest;
                    wrong += std::equal(expected.begin(), expected.end(), actual) ? 0 : 1;
                }
                REQUIRE(wrong == 0);
            }
        }
    }
}

} // namespace hyalite::testing
