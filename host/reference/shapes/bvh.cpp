// Building the tree, and the slab test.
#include "reference/shapes/bvh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hyalite::reference {

Bvh::Bvh(const std::vector<Box>& boxes) : items_(boxes.size()) {
    std::iota(items_.begin(), items_.end(), 0U);
    if (!boxes.empty()) {
        nodes_.reserve(boxes.size()); // leaves hold at least two boxes, unless there is only one
        build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
    }
}

void Bvh::build(const std::vector<Box>& boxes, std::uint32_t begin, std::uint32_t end) {
    Box bounds;
    Box centres;
    for (std::uint32_t i = begin; i < end; ++i) {
        const Box& box = boxes[items_[i]];
        const glm::dvec3 centre = 0.5 * (box.lower + box.upper);
        bounds.include(box);
        centres.include({centre, centre});
    }
    const std::size_t node = nodes_.size();
    nodes_.push_back({.box = bounds, .first = begin, .count = end - begin});
    if (end - begin <= kLeafSize) {
        return;
    }
    const glm::dvec3 extent = centres.upper - centres.lower;
    const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(
        items_.begin() + begin, items_.begin() + middle, items_.begin() + end, [&](std::uint32_t a, std::uint32_t b) {
            return boxes[a].lower[axis] + boxes[a].upper[axis] < boxes[b].lower[axis] + boxes[b].upper[axis];
        });
    build(boxes, begin, middle);
    nodes_[node].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].count = 0;
    nodes_[node].axis = axis;
    build(boxes, middle, end);
}

bool Bvh::meets(const Ray& ray, const glm::dvec3& inverse, double tMin, const Box& box) {
    // Three roundings (subtraction, reciprocal, product) on each side, and as many in the intersections with the box's
    // contents: widen both ends by more than their bound, so that no box is missed. A NaN (0 times infinity: the ray
    // lies in a face) fails both comparisons and clips nothing.
    constexpr double kWiden = 16 * 0x1p-53;
    double enter = tMin;
    double leave = ray.tMax;
    for (int axis = 0; axis < 3; ++axis) {
        double t0 = (box.lower[axis] - ray.origin[axis]) * inverse[axis];
        double t1 = (box.upper[axis] - ray.origin[axis]) * inverse[axis];
        if (inverse[axis] < 0) {
            std::swap(t0, t1);
        }
        t0 -= kWiden * std::abs(t0);
        t1 += kWiden * std::abs(t1);
        enter = t0 > enter ? t0 : enter;
        leave = t1 < leave ? t1 : leave;
    }
    return enter <= leave;
}

} // namespace hyalite::reference
