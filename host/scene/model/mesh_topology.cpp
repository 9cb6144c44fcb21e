// See mesh_topology.h.
#include "scene/model/mesh_topology.h"

#include "scene/model/mesh_weld.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace hyalite {
namespace {

// All edges, stored at their lower vertex: the other vertex, and whether the triangle runs from higher to lower.
class EdgeTable {
public:
    EdgeTable(const Mesh& mesh, const std::vector<std::uint32_t>& vertex) : ends_(mesh.positions.size() + 1, 0) {
        // Count, prefix sum, scatter: each vertex then owns a run of entries.
        forEachEdge(mesh, vertex, [&](std::uint32_t from, std::uint32_t to) { ++ends_[std::min(from, to) + 1]; });
        for (std::size_t i = 1; i < ends_.size(); ++i) {
            ends_[i] += ends_[i - 1];
        }
        entries_.resize(ends_.back());
        forEachEdge(mesh, vertex, [&](std::uint32_t from, std::uint32_t to) {
            // ends_[v] advances from the beginning of v's run to its end, which is the beginning of the run of v + 1.
            entries_[ends_[std::min(from, to)]++] = std::max(from, to) << 1U | (from > to ? 1U : 0U);
        });
    }

    [[nodiscard]] std::optional<std::array<std::uint32_t, 2>> findUnmatched() {
        std::size_t begin = 0;
        for (std::uint32_t low = 0; low + 1 < ends_.size(); ++low) {
            const std::size_t end = ends_[low];
            std::sort(entries_.begin() + static_cast<std::ptrdiff_t>(begin),
                      entries_.begin() + static_cast<std::ptrdiff_t>(end));
            while (begin < end) {
                const std::uint32_t high = entries_[begin] >> 1U;
                std::ptrdiff_t balance = 0; // triangles that run from low to high, minus those from high to low
                for (; begin < end && entries_[begin] >> 1U == high; ++begin) {
                    balance += (entries_[begin] & 1U) == 0 ? 1 : -1;
                }
                if (balance != 0) {
                    return balance > 0 ? std::array{low, high} : std::array{high, low};
                }
            }
        }
        return std::nullopt;
    }

private:
    template <class Visit>
    static void forEachEdge(const Mesh& mesh, const std::vector<std::uint32_t>& vertex, const Visit& visit) {
        for (const glm::uvec3& triangle : mesh.triangles) {
            const glm::uvec3 t(vertex[triangle.x], vertex[triangle.y], vertex[triangle.z]);
            if (t.x != t.y && t.y != t.z && t.z != t.x) {
                visit(t.x, t.y);
                visit(t.y, t.z);
                visit(t.z, t.x);
            }
        }
    }

    std::vector<std::size_t> ends_;
    std::vector<std::uint32_t> entries_;
};

} // namespace

std::optional<OpenEdge> findOpenEdge(const Mesh& mesh) {
    const auto edge = EdgeTable(mesh, weldPositions(mesh.positions)).findUnmatched();
    if (!edge) {
        return std::nullopt;
    }
    return OpenEdge{mesh.positions[(*edge)[0]], mesh.positions[(*edge)[1]]};
}

double signedVolume(const Mesh& mesh) {
    if (mesh.triangles.empty()) {
        return 0;
    }
    // Sum of tetrahedra with their apex on the mesh, not at the origin, which may be far away.
    const glm::dvec3 apex = mesh.positions[mesh.triangles[0].x];
    double sixfold = 0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::dvec3 a = glm::dvec3(mesh.positions[triangle.x]) - apex;
        const glm::dvec3 b = glm::dvec3(mesh.positions[triangle.y]) - apex;
        const glm::dvec3 c = glm::dvec3(mesh.positions[triangle.z]) - apex;
        sixfold += glm::dot(a, glm::cross(b, c));
    }
    return sixfold / 6;
}

bool isInsideOut(const Mesh& mesh) {
    return signedVolume(mesh) < 0;
}

} // namespace hyalite
