#include "reference/photons/radiance_estimate.h"

#include "reference/lights/receiver.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hyalite::reference {

namespace {

// The Gaussian of [Jensen01]
constexpr double kAlpha = 0.918;
constexpr double kBeta = 1.953;

constexpr double kLeastDisc = 0x1p-20; // [largest radius]
constexpr std::size_t kFirstCheck = 8; // photons

// A photon found, as the estimate uses it.
struct Found {
    double distance = 0; // [m]
    double height = 0;   // off the tangent plane [m]
    glm::dvec3 power{0}; // the part that reaches the diffuse surface [W]
};

struct Disc {
    double radius = 0;     // [m]
    std::size_t count = 0; // photons within that radius
};

std::vector<Found> findPhotons(const PhotonMap& map, const VisiblePoint& x, const Receiver& receiver,
                               const RadianceEstimateOptions& options, std::size_t nearest, double radius) {
    const auto counts = [&](const Photon& photon) {
        return isOnSide(photon, x, options.surfaceError) &&
               (options.kinds >> static_cast<std::uint32_t>(photon.kind) & 1U) != 0 &&
               photon.depth + x.depth <= options.maxDepth;
    };
    std::vector<Found> found;
    for (const auto& [distance2, index] : map.nearest(x.position, nearest, radius, counts)) {
        const Photon& photon = map.photons()[index];
        const double entering = receiver.incident(std::clamp(glm::dot(photon.direction, x.normal), 0.0, 1.0));
        found.push_back({.distance = std::sqrt(distance2),
                         .height = std::abs(glm::dot(photon.position - x.position, x.geometricNormal)),
                         .power = isWithinEdges(x, photon.position) ? photon.power * entering : glm::dvec3(0)});
    }
    return found;
}

// The nested discs that are compared, and the density in each.
struct Growth {
    std::vector<Disc> discs;
    std::vector<double> densities;
};

Growth grow(const std::vector<Found>& found, const Disc& whole, double leastRadius) {
    Growth growth;
    std::size_t first = kFirstCheck;
    while (first < whole.count && found[first].distance < leastRadius) {
        ++first;
    }
    for (std::size_t count = first; count < whole.count; count += (count + 3) / 4) {
        const Disc disc{.radius = found[count].distance, .count = count};
        double flux = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (found[i].height <= whole.radius / 4) {
                flux += found[i].power.x + found[i].power.y + found[i].power.z;
            }
        }
        growth.discs.push_back(disc);
        growth.densities.push_back(flux / (disc.radius * disc.radius));
    }
    return growth;
}

Disc stopAtEdge(const std::vector<Found>& found, const Disc& whole, double leastRadius,
                const RadianceEstimateOptions& options) {
    const auto [discs, densities] = grow(found, whole, leastRadius);
    std::size_t start = 0; // from this disc on the density rises monotonically, or falls
    for (std::size_t i = 1; i < discs.size(); ++i) {
        const bool turns = i >= 2 && (densities[i] > densities[i - 1]) != (densities[i - 1] > densities[i - 2]);
        if (turns) {
            start = i - 1;
        }
        const double change = std::abs(densities[i] - densities[start]);
        if (densities[start] > 0 && change > options.maxChange * densities[start]) {
            return discs[start];
        }
    }
    return whole;
}

} // namespace

double filterWeight(const RadianceEstimateOptions& options, double d, double r) {
    switch (options.filter) {
    case PhotonFilter::Cone:
        return 1 - d / (options.coneConstant * r);
    case PhotonFilter::Gaussian:
        return kAlpha * (1 - (1 - std::exp(-kBeta * d * d / (2 * r * r))) / (1 - std::exp(-kBeta)));
    case PhotonFilter::Custom: // without a twin: render() rejects it
    case PhotonFilter::None:
        break;
    }
    return 1;
}

double meanFilterWeight(const RadianceEstimateOptions& options) {
    switch (options.filter) {
    case PhotonFilter::Cone:
        return 1 - 2 / (3 * options.coneConstant);
    case PhotonFilter::Gaussian: {
        // With u = d^2 / r^2, which is uniform on [0, 1] over a disc
        const double meanExponential = 2 / kBeta * (1 - std::exp(-kBeta / 2));
        return kAlpha * (1 - (1 - meanExponential) / (1 - std::exp(-kBeta)));
    }
    case PhotonFilter::Custom:
    case PhotonFilter::None:
        break;
    }
    return 1;
}

RadianceEstimate estimateRadiance(const PhotonMap& map, const VisiblePoint& x, const RadianceEstimateOptions& options) {
    const Receiver receiver = receiverAt(x);
    std::vector<Found> found = findPhotons(map, x, receiver, options, options.nearest, options.radius);
    Disc disc{.radius = options.radius, .count = found.size()};
    if (found.size() == options.nearest) {
        disc = {.radius = found.back().distance, .count = found.size() - 1};
    }
    const double pixel = options.footprint * glm::distance(x.position, options.eye);
    const double least = std::min(options.radius, std::max(pixel, kLeastDisc * options.radius));
    if (disc.radius < least) {
        found = findPhotons(map, x, receiver, options, map.photons().size(), least);
        disc = {.radius = least, .count = found.size()};
    } else if (options.maxChange > 0) {
        disc = stopAtEdge(found, disc, least, options);
    }
    glm::dvec3 power(0);
    for (std::size_t i = 0; i < disc.count; ++i) {
        if (found[i].height <= disc.radius / 4) {
            power += filterWeight(options, found[i].distance, disc.radius) * found[i].power;
        }
    }
    const double area = discOnSurface(x, disc.radius);
    return {.radiance = receiver.f * power / (meanFilterWeight(options) * area), .radius = disc.radius};
}

} // namespace hyalite::reference
