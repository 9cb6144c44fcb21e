// See repeated_faces.h. Hash tables of triangles and polygons whose corners begin with the smallest.
#include "scene/model/repeated_faces.h"

#include "scene/model/mesh_weld.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

namespace hyalite {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

bool isDegenerate(const glm::uvec3& t) {
    return t.x == t.y || t.y == t.z || t.z == t.x;
}

// The same cycle with its smallest corner first.
glm::uvec3 canonical(const glm::uvec3& t) {
    if (t.x < t.y && t.x < t.z) {
        return t;
    }
    return t.y < t.z ? glm::uvec3(t.y, t.z, t.x) : glm::uvec3(t.z, t.x, t.y);
}

std::uint64_t mix(std::uint64_t state, std::uint32_t value) {
    state = (state ^ value) * 0x9e3779b97f4a7c15U;
    return state ^ state >> 32U;
}

// Triangles by their canonical corners: linear probing, at most half full.
class TriangleTable {
public:
    explicit TriangleTable(const Mesh& mesh)
        : mesh_(mesh), vertex_(weldPositions(mesh.positions)),
          slots_(std::bit_ceil(2 * mesh.triangles.size() + 1), kNone) {}

    // The triangle with its welded corners.
    [[nodiscard]] glm::uvec3 corners(std::uint32_t triangle) const {
        const glm::uvec3& t = mesh_.triangles[triangle];
        return {vertex_[t.x], vertex_[t.y], vertex_[t.z]};
    }

    // The first triangle added with these corners in this cyclic order, or kNone.
    [[nodiscard]] std::uint32_t find(const glm::uvec3& corners) const { return slots_[slotOf(corners)]; }

    void add(std::uint32_t triangle) {
        std::uint32_t& slot = slots_[slotOf(corners(triangle))];
        slot = slot == kNone ? triangle : slot;
    }

private:
    [[nodiscard]] std::size_t slotOf(const glm::uvec3& corners) const {
        const glm::uvec3 key = canonical(corners);
        std::size_t slot = mix(mix(mix(0, key.x), key.y), key.z) & (slots_.size() - 1);
        while (slots_[slot] != kNone && canonical(this->corners(slots_[slot])) != key) {
            slot = (slot + 1) & (slots_.size() - 1);
        }
        return slot;
    }

    const Mesh& mesh_;
    std::vector<std::uint32_t> vertex_;
    std::vector<std::uint32_t> slots_;
};

} // namespace

std::optional<RepeatedFaces> dropRepeatedFaces(Mesh& mesh) {
    RepeatedFaces repeated;
    std::vector<bool> isDropped(mesh.triangles.size(), false);
    {
        TriangleTable table(mesh);
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3 corners = table.corners(i);
            if (isDegenerate(corners)) {
                continue;
            }
            const std::uint32_t earlier = table.find(corners);
            if (earlier == kNone) {
                table.add(i);
                continue;
            }
            isDropped[i] = true;
            if (repeated.count++ == 0) {
                repeated.example = {earlier, i};
            }
        }
    }
    if (repeated.count == 0) {
        return std::nullopt;
    }
    if (!mesh.lines.empty()) {
        repeated.line = static_cast<int>(mesh.lines[repeated.example.second]);
        repeated.lineOfFirst = static_cast<int>(mesh.lines[repeated.example.first]);
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!isDropped[i]) {
            mesh.triangles[kept] = mesh.triangles[i];
            if (!mesh.lines.empty()) {
                mesh.lines[kept] = mesh.lines[i];
            }
            ++kept;
        }
    }
    mesh.triangles.resize(kept);
    mesh.lines.resize(mesh.lines.empty() ? 0 : kept);
    return repeated;
}

std::optional<FacePair> findBackToBack(const Mesh& mesh) {
    TriangleTable table(mesh);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 corners = table.corners(i);
        if (isDegenerate(corners)) {
            continue;
        }
        const std::uint32_t back = table.find({corners.x, corners.z, corners.y});
        if (back != kNone) {
            return FacePair{back, i};
        }
        table.add(i);
    }
    return std::nullopt;
}

std::vector<std::uint32_t> turnsToRepeat(std::span<const std::uint32_t> corners, std::span<const std::size_t> ends) {
    struct Known {
        std::size_t begin;
        std::size_t count;
        std::size_t smallest; // place of the smallest corner, from `begin`
    };
    std::vector<std::uint32_t> turns(ends.size(), 0);
    std::unordered_multimap<std::uint64_t, Known> known;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const std::span<const std::uint32_t> polygon = corners.subspan(begin, ends[i] - begin);
        const std::size_t count = polygon.size();
        const auto smallest = static_cast<std::size_t>(std::ranges::min_element(polygon) - polygon.begin());
        std::uint64_t hash = count;
        for (std::size_t k = 0; k < count; ++k) {
            hash = mix(hash, polygon[(smallest + k) % count]);
        }
        bool isNew = true;
        for (auto [at, end] = known.equal_range(hash); at != end && isNew; ++at) {
            const Known& other = at->second;
            bool isSame = other.count == count;
            for (std::size_t k = 0; isSame && k < count; ++k) {
                isSame = corners[other.begin + (other.smallest + k) % count] == polygon[(smallest + k) % count];
            }
            if (isSame) {
                turns[i] = static_cast<std::uint32_t>((smallest + count - other.smallest) % count);
                isNew = false;
            }
        }
        if (isNew) {
            known.emplace(hash, Known{begin, count, smallest});
        }
        begin = ends[i];
    }
    return turns;
}

} // namespace hyalite
