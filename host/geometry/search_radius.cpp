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

// Points along a line that no wall of a usual room is at right angles to.
struct Placed {
    glm::dvec3 point;
    double along = 0;
};

std::vector<Placed> sortedAlongLine(std::span<const glm::dvec3> points) {
    const glm::dvec3 line(0.6, 0.64, 0.48); // unit
    std::vector<Placed> sorted;
    for (const glm::dvec3& point : points) {
        sorted.push_back({point, glm::dot(point, line)});
    }
    std::ranges::sort(sorted, {}, &Placed::along);
    return sorted;
}

// Two points are at least as far apart as along the line: outwards from the point, until that is too far.
double distance2ToNeighbour(std::span<const Placed> sorted, std::size_t i, std::size_t k) {
    std::vector<double> nearest; // a heap of the k least so far
    nearest.reserve(k + 1);
    const auto isTooFar = [&](std::size_t j) {
        const double gap = sorted[j].along - sorted[i].along;
        return nearest.size() == k && gap * gap >= nearest.front();
    };
    const auto add = [&](std::size_t j) {
        const glm::dvec3 way = sorted[j].point - sorted[i].point;
        nearest.push_back(glm::dot(way, way));
        std::ranges::push_heap(nearest);
        if (nearest.size() > k) {
            std::ranges::pop_heap(nearest);
            nearest.pop_back();
        }
    };
    std::size_t below = i; // those from here to before `above` are done
    std::size_t above = i + 1;
    bool more = true;
    while (more) {
        more = false;
        if (below > 0 && !isTooFar(below - 1)) {
            add(--below);
            more = true;
        }
        if (above < sorted.size() && !isTooFar(above)) {
            add(above++);
            more = true;
        }
    }
    return nearest.front();
}

double roundToEighthOctave(double x) {
    return std::exp2(std::round(8 * std::log2(x)) / 8);
}

} // namespace

double typicalSpacing(std::span<const glm::dvec3> points, std::size_t k) {
    const std::vector<Placed> sorted = sortedAlongLine(points);
    std::vector<double> logs(points.size());
    parallelFor(points.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double distance2 = distance2ToNeighbour(sorted, i, k);
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
