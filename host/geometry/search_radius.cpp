#include "geometry/search_radius.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace hyalite {

namespace {

// Enough for a mean, few enough that a corner in which photons of several surfaces meet stays small.
constexpr std::size_t kNeighbour = 10;

// Points in the order of a balanced tree: a node is a range of them, split at its middle one along `axes[middle]`.
class PointTree {
public:
    explicit PointTree(std::span<const glm::dvec3> points)
        : points_(points.begin(), points.end()), axes_(points.size()) {
        build(0, points_.size());
    }

    // Squared distance to the k-th nearest of the others, or to the farthest where there are fewer; 0 where there are
    // none.
    [[nodiscard]] double distance2ToNeighbour(std::size_t i, std::size_t k) const {
        std::vector<double> nearest; // a heap of the k least so far
        nearest.reserve(k + 1);
        search(0, points_.size(), i, k, nearest);
        return nearest.empty() ? 0 : nearest.front();
    }

private:
    void build(std::size_t begin, std::size_t end) {
        if (end - begin < 2) {
            return;
        }
        glm::dvec3 low = points_[begin];
        glm::dvec3 high = low;
        for (std::size_t i = begin; i < end; ++i) {
            low = glm::min(low, points_[i]);
            high = glm::max(high, points_[i]);
        }
        const glm::dvec3 size = high - low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(begin), at(middle), at(end),
                         [axis](const glm::dvec3& a, const glm::dvec3& b) { return a[axis] < b[axis]; });
        axes_[middle] = axis;
        build(begin, middle);
        build(middle + 1, end);
    }

    void search(std::size_t begin, std::size_t end, std::size_t i, std::size_t k, std::vector<double>& nearest) const {
        if (begin == end) {
            return;
        }
        const std::size_t middle = begin + (end - begin) / 2;
        const glm::dvec3 offset = points_[i] - points_[middle];
        if (middle != i) {
            nearest.push_back(glm::dot(offset, offset));
            std::ranges::push_heap(nearest);
            if (nearest.size() > k) {
                std::ranges::pop_heap(nearest);
                nearest.pop_back();
            }
        }
        const double across = offset[axes_[middle]];
        const bool isLow = across < 0;
        search(isLow ? begin : middle + 1, isLow ? middle : end, i, k, nearest);
        if (nearest.size() < k || across * across < nearest.front()) {
            search(isLow ? middle + 1 : begin, isLow ? end : middle, i, k, nearest);
        }
    }

    std::vector<glm::dvec3> points_;
    std::vector<int> axes_;
};

double roundToEighthOctave(double x) {
    return std::exp2(std::round(8 * std::log2(x)) / 8);
}

} // namespace

double typicalSpacing(std::span<const glm::dvec3> points, std::size_t k) {
    const PointTree tree(points);
    std::vector<double> logs(points.size());
    parallelFor(points.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double distance2 = tree.distance2ToNeighbour(i, k);
            logs[i] = std::log(std::max(distance2, std::numeric_limits<double>::min())) / 2;
        }
    });
    return std::exp(std::accumulate(logs.begin(), logs.end(), 0.0) / static_cast<double>(logs.size()));
}

double searchRadiusFor(double wanted, std::span<const glm::dvec3> pilot, std::uint32_t pilotEmitted,
                       std::uint32_t emitted, double sceneRadius) {
    if (pilot.size() < 4 * kNeighbour) {
        return sceneRadius / 100;
    }
    // Photons lie on surfaces: their number within a radius goes as its square
    const double more = static_cast<double>(emitted) / pilotEmitted;
    const double radius = typicalSpacing(pilot, kNeighbour) * std::sqrt(wanted / (kNeighbour * more));
    return roundToEighthOctave(std::clamp(radius, sceneRadius / 2000, sceneRadius / 20));
}

} // namespace hyalite
