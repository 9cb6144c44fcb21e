#include "geometry/search_radius.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
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

    [[nodiscard]] const glm::dvec3& point(std::size_t i) const { return points_[i]; }

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

// A point, and the distance to its k-th neighbour.
struct Spacing {
    glm::dvec3 point;
    double distance;
};

// In the order of the tree.
std::vector<Spacing> spacings(std::span<const glm::dvec3> points, std::size_t k) {
    const PointTree tree(points);
    std::vector<Spacing> result(points.size());
    parallelFor(points.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double distance2 = std::max(tree.distance2ToNeighbour(i, k), std::numeric_limits<double>::min());
            result[i] = {tree.point(i), std::sqrt(distance2)};
        }
    });
    return result;
}

// The value that a share of them does not exceed.
double quantile(std::vector<double> values, double share) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

// The distance from each point to its k-th neighbour, times `scale`; at least the distance to the eye times `slope`,
// and 2^-18 of the largest coordinate, which floats resolve.
std::vector<double> radiiAround(std::span<const glm::dvec3> points, std::size_t k, double scale, double slope,
                                const glm::dvec3& eye) {
    std::vector<double> radii;
    for (const Spacing& spacing : spacings(points, k)) {
        const glm::dvec3 size = glm::abs(spacing.point);
        radii.push_back(std::max({scale * spacing.distance, slope * glm::distance(spacing.point, eye),
                                  0x1p-18 * std::max({size.x, size.y, size.z})}));
    }
    return radii;
}

// The neighbour whose distance is measured among so many points.
std::size_t neighbourAmong(std::size_t count) {
    return std::clamp<std::size_t>(count / 4, 1, kNeighbour);
}

} // namespace

double typicalSpacing(std::span<const glm::dvec3> points, std::size_t k) {
    std::vector<double> distances;
    for (const Spacing& spacing : spacings(points, k)) {
        distances.push_back(spacing.distance);
    }
    return quantile(std::move(distances), 0.5);
}

double searchRadiusFor(double wanted, std::span<const glm::dvec3> pilot, std::uint32_t pilotEmitted,
                       std::uint32_t emitted, const RadiusBounds& bounds) {
    if (pilot.size() < 4) {
        return bounds.sceneRadius / 100;
    }
    // Photons lie on surfaces: their number within a radius goes as its square
    const std::size_t k = neighbourAmong(pilot.size());
    const double more = static_cast<double>(emitted) / pilotEmitted;
    const double scale = std::sqrt(wanted / (static_cast<double>(k) * more));
    const std::vector<double> radii = radiiAround(pilot, k, scale, bounds.footprint, bounds.eye);
    return roundToEighthOctave(std::min(quantile(radii, 0.5), bounds.sceneRadius / 20));
}

double largestEstimateFor(std::size_t nearest, std::span<const glm::dvec3> photons, double largest,
                          const RadiusBounds& bounds) {
    if (photons.size() < 4) {
        return largest;
    }
    // Every n-th photon stands for n: the spacing of all of them is less by the root of that
    const std::size_t every = (photons.size() + kPilotPhotons - 1) / kPilotPhotons;
    std::vector<glm::dvec3> some;
    for (std::size_t i = 0; i < photons.size(); i += every) {
        some.push_back(photons[i]);
    }
    const std::size_t k = neighbourAmong(some.size());
    const double scale = std::sqrt(static_cast<double>(nearest) / static_cast<double>(k * every));
    const std::vector<double> radii = radiiAround(some, k, scale, bounds.footprint, bounds.eye);
    return std::min(largest, roundToEighthOctave(4 * quantile(radii, 0.5)));
}

} // namespace hyalite
