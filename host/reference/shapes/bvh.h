// Bounding volume hierarchy over boxes: binary, split at the median of the longest axis. Deliberately simple: it shares
// nothing with the tree that the kernels traverse.
#pragma once

#include "reference/shapes/ray.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

namespace hyalite::reference {

struct Box {
    glm::dvec3 lower{std::numeric_limits<double>::infinity()};
    glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

    void include(const Box& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
};

class Bvh {
public:
    Bvh() = default;
    explicit Bvh(const std::vector<Box>& boxes);

    // Calls visit(index of a box) for every box that the ray may cross at some t in [tMin, ray.tMax], mostly nearer
    // boxes first. The visitor may lower ray.tMax; the traversal ends when it returns false.
    template <typename Visit>
    void walk(Ray& ray, Visit&& visit, double tMin = 0) const;

private:
    static constexpr std::uint32_t kLeafSize = 4;
    static constexpr std::size_t kMaxTreeDepth = 40; // halving 2^32 boxes down to leaves takes fewer levels

    struct Node {
        Box box;
        std::uint32_t first = 0; // leaf: first of items_; inner: right child (the left one follows its parent)
        std::uint32_t count = 0; // leaf: number of items_; inner: 0
        int axis = 0;            // inner: along which the children are ordered
    };

    void build(const std::vector<Box>& boxes, std::uint32_t begin, std::uint32_t end);
    [[nodiscard]] static bool meets(const Ray& ray, const glm::dvec3& inverse, double tMin, const Box& box);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> items_; // indices of boxes, leaf by leaf
};

template <typename Visit>
void Bvh::walk(Ray& ray, Visit&& visit, double tMin) const {
    if (nodes_.empty()) {
        return;
    }
    const glm::dvec3 inverse = 1.0 / ray.direction;
    std::array<std::uint32_t, kMaxTreeDepth> stack{};
    std::size_t size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const std::uint32_t index = stack[--size];
        const Node& node = nodes_[index];
        if (!meets(ray, inverse, tMin, node.box)) {
            continue;
        }
        for (std::uint32_t i = 0; i < node.count; ++i) {
            if (!visit(items_[node.first + i])) {
                return;
            }
        }
        if (node.count == 0) {
            const bool leftFirst = ray.direction[node.axis] >= 0;
            stack[size++] = leftFirst ? node.first : index + 1;
            stack[size++] = leftFirst ? index + 1 : node.first;
        }
    }
}

} // namespace hyalite::reference
