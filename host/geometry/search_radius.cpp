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

double distance2ToNeighbour(std::span<const glm::dvec3> points, std::size_t i, std::size_t k) {
    std::vector<double> nearest; // a heap of the k least so far
    nearest.reserve(k + 1);
    for (std::size_t j = 0; j < points.size(); ++j) {
        const glm::dvec3 way = points[j] - points[i];
        const double distance2 = glm::dot(way, way);
        if (j == i || (nearest.size() == k && distance2 >= nearest.front())) {
            continue;
        }
        nearest.push_back(distance2);
        std::ranges::push_heap(nearest);
        if (nearest.size() > k) {
            std::ranges::pop_heap(nearest);
            nearest.pop_back();
        }
    }
    return nearest.front();
}

double roundToEighthOctave(double x) {
    return std::exp2(std::round(8 * std::log2(x)) / 8);
}

} // namespace

double typicalSpacing(std::span<const glm::dvec3> points, std::size_t k) {
    std::vector<double> logs(points.size());
    parallelFor(points.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double distance2 = distance2ToNeighbour(points, i, k);
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
