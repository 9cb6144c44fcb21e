// See mesh_weld.h. A hash table with linear probing: linear time, 8 to 16 bytes per position besides the result.
#include "scene/model/mesh_weld.h"

#include <bit>
#include <type_traits>

namespace hyalite {
namespace {

constexpr std::uint32_t kEmpty = 0xffffffffU;

template <class Position>
std::uint64_t hash(const Position& position) {
    using Bits = std::conditional_t<std::is_same_v<Position, glm::vec3>, std::uint32_t, std::uint64_t>;
    std::uint64_t state = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto canonical = position[axis] + typename Position::value_type{0}; // -0 becomes 0
        state = (state ^ std::bit_cast<Bits>(canonical)) * 0x9e3779b97f4a7c15U;
        state ^= state >> 32U;
    }
    return state;
}

template <class Position>
std::vector<std::uint32_t> weld(std::span<const Position> positions) {
    std::vector<std::uint32_t> first(positions.size());
    // At most half full, so that probing stays short.
    const std::size_t slots = std::bit_ceil(2 * positions.size() + 1);
    std::vector<std::uint32_t> table(slots, kEmpty);
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::size_t slot = hash(positions[i]) & (slots - 1);
        while (table[slot] != kEmpty && positions[table[slot]] != positions[i]) {
            slot = (slot + 1) & (slots - 1);
        }
        if (table[slot] == kEmpty) {
            table[slot] = i;
        }
        first[i] = table[slot];
    }
    return first;
}

} // namespace

std::vector<std::uint32_t> weldPositions(std::span<const glm::vec3> positions) {
    return weld(positions);
}

std::vector<std::uint32_t> weldPositions(std::span<const glm::dvec3> positions) {
    return weld(positions);
}

void weldVertices(Mesh& mesh) {
    std::vector<std::uint32_t> index = weldPositions(mesh.positions);
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < index.size(); ++i) {
        if (index[i] == i) {
            mesh.positions[kept] = mesh.positions[i];
            index[i] = kept++;
        } else {
            index[i] = index[index[i]]; // the first equal position already has its new index
        }
    }
    mesh.positions.resize(kept);
    mesh.positions.shrink_to_fit();
    for (glm::uvec3& triangle : mesh.triangles) {
        triangle = {index[triangle.x], index[triangle.y], index[triangle.z]};
    }
}

} // namespace hyalite
