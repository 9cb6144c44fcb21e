// See mesh_shells.h. Edges are sorted; a search over neighbours numbers the shells and finds the turned triangles.
#include "scene/model/mesh_shells.h"

#include "scene/model/mesh_weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace hyalite {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

// A triangle's run along the edge between two corners.
struct Side {
    std::uint32_t low = 0; // corners
    std::uint32_t high = 0;
    std::uint32_t triangle = 0;
    bool isRising = false; // from low to high

    [[nodiscard]] bool sameEdge(const Side& other) const { return low == other.low && high == other.high; }
};

// For each position the index of the first one at most `reach` away along each axis, or of one found equal to that.
std::vector<std::uint32_t> weldWithin(const std::vector<glm::vec3>& positions, double reach) {
    const double cell = 4 * reach;
    const auto key = [](const std::array<std::int64_t, 3>& at) {
        std::uint64_t state = 0;
        for (const std::int64_t one : at) {
            state = (state ^ static_cast<std::uint64_t>(one)) * 0x9e3779b97f4a7c15U;
            state ^= state >> 32U;
        }
        return state;
    };
    const auto cellOf = [&](const glm::dvec3& p) {
        return key({std::llround(std::floor(p.x / cell)), std::llround(std::floor(p.y / cell)),
                    std::llround(std::floor(p.z / cell))});
    };
    std::vector<std::uint32_t> first(positions.size());
    std::unordered_multimap<std::uint64_t, std::uint32_t> known;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        const glm::dvec3 p = positions[i];
        first[i] = i;
        for (int corner = 0; corner < 8 && first[i] == i; ++corner) { // the cells within reach
            const glm::dvec3 near = p + reach * glm::dvec3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                                           (corner & 4) != 0 ? 1 : -1);
            for (auto [at, end] = known.equal_range(cellOf(near)); at != end && first[i] == i; ++at) {
                const glm::dvec3 off = glm::abs(glm::dvec3(positions[at->second]) - p);
                first[i] = std::max({off.x, off.y, off.z}) <= reach ? at->second : i;
            }
        }
        if (first[i] == i) {
            known.emplace(cellOf(p), i);
        }
    }
    return first;
}

std::vector<Side> sidesOf(const Mesh& mesh, const std::vector<std::uint32_t>& corner) {
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const std::array c{corner[t.x], corner[t.y], corner[t.z]};
        if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) {
            continue;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = c.at(k);
            const std::uint32_t to = c.at((k + 1) % 3);
            sides.push_back({std::min(from, to), std::max(from, to), i, from < to});
        }
    }
    std::ranges::sort(sides, [](const Side& a, const Side& b) {
        return std::array{a.low, a.high, a.triangle} < std::array{b.low, b.high, b.triangle};
    });
    return sides;
}

// Calls visit(begin, end) for the sides along each edge.
template <class Visit>
void forEachEdge(const std::vector<Side>& sides, const Visit& visit) {
    for (std::size_t begin = 0; begin < sides.size();) {
        std::size_t end = begin + 1;
        while (end < sides.size() && sides[end].sameEdge(sides[begin])) {
            ++end;
        }
        visit(begin, end);
        begin = end;
    }
}

class ShellFinder {
public:
    ShellFinder(const Mesh& mesh, std::vector<Side> sides) : mesh_(mesh), sides_(std::move(sides)) {
        neighbours_.assign(mesh.triangles.size(), {kNone, kNone, kNone});
        isOpen_.assign(mesh.triangles.size(), false);
        forEachEdge(sides_, [&](std::size_t begin, std::size_t end) {
            if (end - begin == 1) {
                isOpen_[sides_[begin].triangle] = true;
            } else if (end - begin == 2 && sides_[begin].triangle != sides_[begin + 1].triangle) {
                const bool agree = sides_[begin].isRising != sides_[begin + 1].isRising;
                link(sides_[begin].triangle, sides_[begin + 1].triangle, agree);
                link(sides_[begin + 1].triangle, sides_[begin].triangle, agree);
            } else {
                isManifold_ = false;
            }
        });
    }

    std::vector<MeshShell> find() {
        std::vector<MeshShell> shells;
        std::vector<std::uint8_t> state(mesh_.triangles.size(), kUnseen);
        for (const Side& side : byTriangle()) {
            if (isManifold_ && state[side.triangle] == kUnseen) {
                shells.push_back(spread(side.triangle, state));
            }
        }
        if (!isManifold_) {
            shells = {wholeMesh()};
        }
        for (MeshShell& shell : shells) {
            measure(shell);
        }
        return shells;
    }

private:
    enum : std::uint8_t { kUnseen, kAsFirst, kTurned };

    // A neighbour's number, doubled, plus one if it is wound the other way round.
    void link(std::uint32_t triangle, std::uint32_t other, bool agree) {
        for (std::uint32_t& free : neighbours_[triangle]) {
            if (free == kNone) {
                free = 2 * other + (agree ? 0 : 1);
                return;
            }
        }
    }

    // One side of every triangle, in the order of the mesh.
    [[nodiscard]] std::vector<Side> byTriangle() const {
        std::vector<Side> first(mesh_.triangles.size(), Side{0, 0, kNone, false});
        for (const Side& side : sides_) {
            first[side.triangle] = side;
        }
        std::erase_if(first, [](const Side& side) { return side.triangle == kNone; });
        return first;
    }

    // The shell of a triangle. A surface with one side only makes the mesh count as no manifold.
    MeshShell spread(std::uint32_t seed, std::vector<std::uint8_t>& state) {
        MeshShell shell;
        std::vector<std::uint32_t> next{seed};
        state[seed] = kAsFirst;
        while (!next.empty()) {
            const std::uint32_t at = next.back();
            next.pop_back();
            shell.triangles.push_back(at);
            if (state[at] == kTurned) {
                shell.turned.push_back(at);
            }
            if (isOpen_[at]) {
                shell.open.push_back(at);
            }
            for (const std::uint32_t neighbour : neighbours_[at]) {
                if (neighbour == kNone) {
                    continue;
                }
                const std::uint32_t other = neighbour / 2;
                const bool isTurned = (state[at] == kTurned) != (neighbour % 2 == 1);
                const std::uint8_t wanted = isTurned ? kTurned : kAsFirst;
                if (state[other] == kUnseen) {
                    state[other] = wanted;
                    next.push_back(other);
                } else if (state[other] != wanted) {
                    isManifold_ = false;
                }
            }
        }
        std::ranges::sort(shell.triangles);
        std::ranges::sort(shell.turned);
        std::ranges::sort(shell.open);
        return shell;
    }

    [[nodiscard]] MeshShell wholeMesh() const {
        MeshShell shell;
        for (const Side& side : byTriangle()) {
            shell.triangles.push_back(side.triangle);
        }
        forEachEdge(sides_, [&](std::size_t begin, std::size_t end) {
            std::ptrdiff_t balance = 0;
            for (std::size_t i = begin; i < end; ++i) {
                balance += sides_[i].isRising ? 1 : -1;
            }
            if (balance != 0) {
                for (std::size_t i = begin; i < end; ++i) {
                    shell.open.push_back(sides_[i].triangle);
                }
            }
        });
        std::ranges::sort(shell.open);
        shell.open.erase(std::unique(shell.open.begin(), shell.open.end()), shell.open.end());
        return shell;
    }

    // Sums tetrahedra with their apex on the shell, not at the origin, which may be far away.
    void measure(MeshShell& shell) const {
        if (shell.triangles.empty()) {
            return;
        }
        const glm::dvec3 apex = mesh_.positions[mesh_.triangles[shell.triangles.front()].x];
        std::size_t turned = 0;
        for (const std::uint32_t i : shell.triangles) {
            const glm::uvec3& t = mesh_.triangles[i];
            const glm::dvec3 a = glm::dvec3(mesh_.positions[t.x]) - apex;
            const glm::dvec3 b = glm::dvec3(mesh_.positions[t.y]) - apex;
            const glm::dvec3 c = glm::dvec3(mesh_.positions[t.z]) - apex;
            const bool isTurned = turned < shell.turned.size() && shell.turned[turned] == i;
            turned += isTurned ? 1 : 0;
            shell.volume += (isTurned ? -1.0 : 1.0) * glm::dot(a, glm::cross(b, c)) / 6;
            shell.area += glm::length(glm::cross(b - a, c - a)) / 2;
        }
    }

    const Mesh& mesh_;
    std::vector<Side> sides_;
    std::vector<std::array<std::uint32_t, 3>> neighbours_;
    std::vector<bool> isOpen_;
    bool isManifold_ = true;
};

bool hasOpenEdge(const std::vector<Side>& sides) {
    bool isOpen = false;
    forEachEdge(sides, [&](std::size_t begin, std::size_t end) { isOpen = isOpen || end - begin == 1; });
    return isOpen;
}

} // namespace

std::vector<MeshShell> shellsOf(const Mesh& mesh) {
    std::vector<Side> sides = sidesOf(mesh, weldPositions(mesh.positions));
    if (hasOpenEdge(sides)) {
        float largest = 0;
        for (const glm::vec3& p : mesh.positions) {
            largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        }
        constexpr double kSixDigits = 1.1e-5; // two roundings to six digits differ by 1e-5 of the number at most
        std::vector<Side> welded = sidesOf(mesh, weldWithin(mesh.positions, kSixDigits * static_cast<double>(largest)));
        if (!hasOpenEdge(welded)) {
            sides = std::move(welded);
        }
    }
    return ShellFinder(mesh, std::move(sides)).find();
}

void turn(Mesh& mesh, const std::vector<std::uint32_t>& triangles) {
    for (const std::uint32_t i : triangles) {
        std::swap(mesh.triangles[i].y, mesh.triangles[i].z);
    }
}

} // namespace hyalite
