// Turns the binary tree into 4-wide nodes with children's boxes in 8 bits a side [Ylitie17]: 48 bytes a node.
#include "geometry/bvh_collapse.h"

#include "shaders/shared/limits.h"
#include "shaders/shared/scene_records.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace hyalite {

namespace {

using shared::kTexelsPerRecord;

constexpr int kExponentBias = 127;

// The grid that a node's child boxes are rounded to: origin + byte * 2^(exponent - bias) along each axis.
struct Frame {
    glm::vec3 origin{0};
    std::array<int, 3> exponent{1, 1, 1};

    // Boxes grow by a few roundings of their coordinates first: what the ray's own rounding may miss.
    static glm::dvec3 padding(const Aabb& node) {
        return glm::dvec3(glm::max(glm::abs(node.lower), glm::abs(node.upper))) * 0x1p-20 + 1e-30;
    }

    explicit Frame(const Aabb& node) {
        if (node.empty()) {
            return;
        }
        const glm::dvec3 pad = padding(node);
        for (int axis = 0; axis < 3; ++axis) {
            const double lower = static_cast<double>(node.lower[axis]) - 2 * pad[axis];
            origin[axis] = std::nextafter(static_cast<float>(lower), -std::numeric_limits<float>::infinity());
            const double extent =
                static_cast<double>(node.upper[axis]) + 2 * pad[axis] - static_cast<double>(origin[axis]);
            int e = 0;
            std::frexp(extent / 255.0, &e); // extent / 255 <= 2^e
            exponent[static_cast<std::size_t>(axis)] = std::clamp(e + kExponentBias, 1, 254);
        }
    }

    [[nodiscard]] double steps(double coordinate, int axis) const {
        const int e = exponent[static_cast<std::size_t>(axis)] - kExponentBias;
        return (coordinate - static_cast<double>(origin[axis])) * std::ldexp(1.0, -e);
    }
    [[nodiscard]] std::uint32_t lower(const Aabb& box, double pad, int axis) const {
        const double q = std::floor(steps(static_cast<double>(box.lower[axis]) - pad, axis));
        return static_cast<std::uint32_t>(std::clamp(q, 0.0, 255.0));
    }
    [[nodiscard]] std::uint32_t upper(const Aabb& box, double pad, int axis) const {
        const double q = std::ceil(steps(static_cast<double>(box.upper[axis]) + pad, axis));
        return static_cast<std::uint32_t>(std::clamp(q, 0.0, 255.0));
    }
    [[nodiscard]] glm::uvec4 texel() const {
        const auto bits = static_cast<std::uint32_t>(exponent[0] | exponent[1] << 8 | exponent[2] << 16);
        return {std::bit_cast<std::uint32_t>(origin.x), std::bit_cast<std::uint32_t>(origin.y),
                std::bit_cast<std::uint32_t>(origin.z), bits};
    }
};

class Packer {
public:
    Packer(const BinaryBvh& binary, std::uint32_t leafSize) : binary_(binary), collapse_(binary, leafSize) {}

    Bvh pack() {
        bvh_.order.reserve(binary_.order.size());
        bvh_.texels.resize(kTexelsPerRecord);
        bvh_.stackEntries = packNode(0, 0);
        return std::move(bvh_);
    }

private:
    // Fills the node's record and appends all below it; returns the stack entries that traversal from here needs.
    std::uint32_t packNode(std::size_t node, std::uint32_t slot) {
        const std::vector<std::uint32_t> list = collapse_.children(slot);
        const Aabb& box = binary_.nodes[slot].box;
        const Frame frame(box);
        const glm::dvec3 pad = list.empty() ? glm::dvec3(0) : Frame::padding(box);
        glm::uvec4 first = frame.texel();
        glm::uvec4 low(0);
        glm::uvec4 high(0, 0, bvh_.texels.size() / kTexelsPerRecord, bvh_.order.size());
        std::vector<std::uint32_t> inner;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const BinaryNode& child = binary_.nodes[list[i]];
            const auto shift = static_cast<std::uint32_t>(8 * i);
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] |= frame.lower(child.box, pad[axis], axis) << shift;
            }
            low[3] |= frame.upper(child.box, pad[0], 0) << shift;
            high[0] |= frame.upper(child.box, pad[1], 1) << shift;
            high[1] |= frame.upper(child.box, pad[2], 2) << shift;
            setKind(first, high, i, collapse_.isLeaf(list[i]) ? child.count : shared::kInnerChild);
            if (collapse_.isLeaf(list[i])) {
                const auto elements = binary_.order.begin() + child.first;
                bvh_.order.insert(bvh_.order.end(), elements, elements + child.count);
            } else {
                inner.push_back(list[i]);
            }
        }
        const std::size_t firstInner = bvh_.texels.size();
        bvh_.texels.resize(firstInner + inner.size() * kTexelsPerRecord);
        bvh_.texels[node] = first;
        bvh_.texels[node + 1] = low;
        bvh_.texels[node + 2] = high;

        std::uint32_t below = 1;
        for (std::size_t i = 0; i < inner.size(); ++i) {
            below = std::max(below, packNode(firstInner + i * kTexelsPerRecord, inner[i]));
        }
        return static_cast<std::uint32_t>(std::max<std::size_t>(list.size(), 1) - 1) + below;
    }

    static void setKind(glm::uvec4& first, glm::uvec4& last, std::size_t child, std::uint32_t kind) {
        if (child < 2) {
            first.w |= kind << (24 + 4 * child);
        } else {
            last[static_cast<int>(child)] |= kind << shared::kChildKindShift;
        }
    }

    const BinaryBvh& binary_;
    BvhCollapse collapse_;
    Bvh bvh_;
};

} // namespace

Bvh packBvh(const BinaryBvh& binary, std::uint32_t leafSize) {
    return Packer(binary, leafSize).pack();
}

glm::uvec4 childWords(std::span<const glm::uvec4> node) {
    const std::array kinds{node[0].w >> 24U & 15U, node[0].w >> 28U, node[2].z >> shared::kChildKindShift,
                           node[2].w >> shared::kChildKindShift};
    std::uint32_t nextNode = node[2].z & shared::kLeafFirstMask;
    std::uint32_t nextElement = node[2].w & shared::kLeafFirstMask;
    glm::uvec4 words(shared::kNone);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] == shared::kInnerChild) {
            words[static_cast<int>(i)] = nextNode++;
        } else if (kinds[i] != 0) {
            words[static_cast<int>(i)] = shared::kLeafBit | kinds[i] << shared::kLeafCountShift | nextElement;
            nextElement += kinds[i];
        }
    }
    return words;
}

void relocate(Bvh& bvh, std::uint32_t firstNode, std::uint32_t firstElement) {
    for (std::size_t node = 0; node < bvh.texels.size(); node += kTexelsPerRecord) {
        bvh.texels[node + 2].z += firstNode;
        bvh.texels[node + 2].w += firstElement;
    }
}

} // namespace hyalite
