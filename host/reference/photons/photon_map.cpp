// The map is a nanoflann kd-tree over the photons' positions.
#include "reference/photons/photon_map.h"

#include "reference/lights/receiver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <nanoflann.hpp>
#include <numbers>
#include <set>
#include <utility>

namespace hyalite::reference {

namespace {

using std::numbers::pi;

struct PhotonCloud { // the interface that nanoflann requires of its points
    std::vector<Photon> photons;

    [[nodiscard]] std::size_t kdtree_get_point_count() const { return photons.size(); }
    [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t axis) const {
        return photons[index].position[static_cast<int>(axis)];
    }
    template <typename Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
        return false;
    } // let the tree compute it
};

// Collects candidates from nanoflann's traversal; the library's own result sets differ between its versions.
struct Candidates {
    using DistanceType = double; // required since version 1.7
    using IndexType = std::uint32_t;

    double worst; // squared distance [m^2]
    std::vector<std::uint32_t>& indices;

    [[nodiscard]] std::size_t size() const { return indices.size(); }
    [[nodiscard]] static bool full() { return true; }
    [[nodiscard]] double worstDist() const { return worst; }
    bool addPoint(double /*distance2*/, std::uint32_t index) {
        indices.push_back(index);
        return true;
    }
    void sort() { std::sort(indices.begin(), indices.end()); }
};

// Keeps the nearest of the photons that are accepted, in order.
struct NearestCandidates {
    using DistanceType = double;
    using IndexType = std::uint32_t;

    const glm::dvec3& x;
    std::size_t count;
    double reach2; // squared distance of the farthest candidate still of interest [m^2]
    const std::vector<Photon>& photons;
    const std::function<bool(const Photon&)>& accept;
    std::set<std::pair<double, std::uint32_t>> found;

    [[nodiscard]] std::size_t size() const { return found.size(); }
    [[nodiscard]] static bool full() { return true; }
    // The traversal accumulates squared distances with rounding and skips candidates at exactly this distance: let it
    // search slightly farther.
    [[nodiscard]] double worstDist() const {
        const double worst = found.size() < count ? reach2 : found.rbegin()->first;
        return worst * (1 + 1e-12) + std::numeric_limits<double>::min();
    }
    bool addPoint(double /*distance2*/, std::uint32_t index) {
        const glm::dvec3 way = photons[index].position - x;
        const double distance2 = glm::dot(way, way);
        if (distance2 <= reach2 && accept(photons[index])) {
            found.emplace(distance2, index);
            if (found.size() > count) {
                found.erase(std::prev(found.end()));
            }
        }
        return true;
    }
    void sort() {} // already sorted
};

using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PhotonCloud>, PhotonCloud, 3,
                                                  std::uint32_t>;

} // namespace

struct PhotonMap::Tree {
    explicit Tree(std::vector<Photon> photons)
        : cloud{std::move(photons)}, index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {
        index.buildIndex();
    }

    PhotonCloud cloud;
    Index index; // refers to the cloud
};

PhotonMap::PhotonMap(std::vector<Photon> photons) : tree_(std::make_unique<Tree>(std::move(photons))) {}
PhotonMap::~PhotonMap() = default;
PhotonMap::PhotonMap(PhotonMap&&) noexcept = default;
PhotonMap& PhotonMap::operator=(PhotonMap&&) noexcept = default;

const std::vector<Photon>& PhotonMap::photons() const {
    return tree_->cloud.photons;
}

std::vector<std::uint32_t> PhotonMap::near(const glm::dvec3& x, double radius) const {
    // The tree accumulates squared distances with rounding: search slightly wider, then apply the definition.
    std::vector<std::uint32_t> indices;
    Candidates candidates{.worst = radius * radius * (1 + 1e-12), .indices = indices};
    tree_->index.findNeighbors(candidates, &x.x, {});
    std::erase_if(indices, [&](std::uint32_t i) {
        const glm::dvec3 way = photons()[i].position - x;
        return glm::dot(way, way) > radius * radius;
    });
    std::sort(indices.begin(), indices.end());
    return indices;
}

std::vector<PhotonMap::Neighbour> PhotonMap::nearest(const glm::dvec3& x, std::size_t count, double radius,
                                                     const std::function<bool(const Photon&)>& accept) const {
    NearestCandidates candidates{
        .x = x, .count = count, .reach2 = radius * radius, .photons = photons(), .accept = accept, .found = {}};
    if (count > 0) {
        tree_->index.findNeighbors(candidates, &x.x, {});
    }
    std::vector<Neighbour> neighbours;
    for (const auto& [distance2, index] : candidates.found) {
        neighbours.push_back({distance2, index});
    }
    return neighbours;
}

double discOnQuad(const Quad& quad, const glm::dvec3& center, double radius) {
    const glm::dvec3 normal = glm::normalize(glm::cross(quad.edge0, quad.edge1));
    const std::array<glm::dvec3, 4> corners{quad.corner, quad.corner + quad.edge0,
                                            quad.corner + quad.edge0 + quad.edge1, quad.corner + quad.edge1};
    // In polar coordinates about the centre the area is half the integral of min(rho, r)^2 over the angle, side by
    // side. At the angle phi from the perpendicular, h long, a side has rho = h / cos(phi), and h^2 / cos^2 is the
    // derivative of h^2 tan; it lies within the disc where |phi| < acos(h / r).
    double area = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 a = corners[i] - center;
        const glm::dvec3 b = corners[(i + 1) % 4] - center;
        const glm::dvec3 side = glm::normalize(b - a);
        const double h = glm::dot(glm::cross(a, side), normal); // negative: seen from beyond the side
        const double within = std::abs(h) < radius ? std::acos(std::abs(h) / radius) : 0;
        const auto integral = [&](const glm::dvec3& end) {
            const double phi = std::atan2(glm::dot(end, side), std::abs(h));
            const double inDisc = std::clamp(phi, -within, within);
            return (h * h * std::tan(inDisc) + radius * radius * (phi - inDisc)) / 2;
        };
        area += std::copysign(integral(b) - integral(a), h);
    }
    const double whole = pi * radius * radius;
    return std::clamp(area, whole / 1024, whole);
}

namespace {

// The area that two discs share is the integral over the second of the indicator of the first. In polar coordinates
// about the first's centre, rings of radius rho < r are covered by the second for an angle that ends where the rims
// cross; the closed form is that of two circular segments.
double discOnDisc(double r, double s, double d) {
    if (d <= std::abs(r - s)) {
        return pi * std::min(r, s) * std::min(r, s);
    }
    if (d >= r + s) {
        return 0;
    }
    const double alpha = 2 * std::acos(std::clamp((d * d + r * r - s * s) / (2 * d * r), -1.0, 1.0));
    const double beta = 2 * std::acos(std::clamp((d * d + s * s - r * r) / (2 * d * s), -1.0, 1.0));
    return (r * r * (alpha - std::sin(alpha)) + s * s * (beta - std::sin(beta))) / 2;
}

} // namespace

namespace {

bool isRound(const Disk& disk) {
    const double rim = glm::length(disk.axis0);
    const double skew = std::abs(glm::dot(disk.axis0, disk.axis1)) / rim;
    return std::abs(glm::length(disk.axis1) - rim) + skew < 5e-5 * rim;
}

} // namespace

double discOnSurface(const VisiblePoint& x, double radius) {
    if (x.quad != nullptr) {
        return discOnQuad(*x.quad, x.position, radius);
    }
    const double whole = pi * radius * radius;
    if (x.disk != nullptr && isRound(*x.disk)) {
        const double rim = glm::length(x.disk->axis0);
        return std::max(discOnDisc(radius, rim, glm::distance(x.position, x.disk->center)), whole / 1024);
    }
    return whole;
}

bool isWithinEdges(const VisiblePoint& x, const glm::dvec3& place) {
    constexpr double rounding = 1e-6; // of a photon's coordinates on the shape
    if (x.quad != nullptr) {
        const glm::dvec3 normal = glm::cross(x.quad->edge0, x.quad->edge1);
        const glm::dvec3 from = place - x.quad->corner;
        const double u = glm::dot(glm::cross(from, x.quad->edge1), normal) / glm::dot(normal, normal);
        const double v = glm::dot(glm::cross(x.quad->edge0, from), normal) / glm::dot(normal, normal);
        return std::min(u, v) >= -rounding && std::max(u, v) <= 1 + rounding;
    }
    if (x.disk != nullptr && isRound(*x.disk)) {
        const glm::dvec3 normal = glm::normalize(glm::cross(x.disk->axis0, x.disk->axis1));
        const glm::dvec3 from = place - x.disk->center;
        return glm::length(from - glm::dot(from, normal) * normal) <= glm::length(x.disk->axis0) * (1 + rounding / 2);
    }
    return true;
}

bool isOnSurface(const Photon& photon, const VisiblePoint& x, double surfaceError) {
    const glm::dvec3 chord = photon.position - x.position;
    const double cosine = glm::dot(photon.normal, x.geometricNormal);
    if (cosine <= 0.5) {
        return false;
    }
    const glm::dvec3 size = glm::abs(x.position);
    const double error = surfaceError + 0x1p-19 * std::max({size.x, size.y, size.z});
    const double sine = glm::length(glm::cross(photon.normal, x.geometricNormal));
    if (sine < 0.0012) {
        return std::abs(glm::dot(chord, x.geometricNormal)) <= std::hypot(0.001 * glm::length(chord), error);
    }
    const double off = glm::dot(chord, (photon.normal + x.geometricNormal) / 2.0);
    return std::abs(off) <= std::hypot(std::hypot(0.004, sine) * glm::length(chord), error);
}

bool isOnSide(const Photon& photon, const VisiblePoint& x, double surfaceError) {
    return glm::dot(photon.direction, x.geometricNormal) > 0 && isOnSurface(photon, x, surfaceError);
}

std::optional<glm::dvec3> recordedIrradiance(const PhotonMap& records, const VisiblePoint& y, double radius,
                                             double surfaceError) {
    const auto nearest = records.nearest(y.position, 1, radius, [&](const Photon& record) {
        return glm::distance(record.position, y.position) <= record.discRadius && isOnSurface(record, y, surfaceError);
    });
    return nearest.empty() ? std::nullopt : std::optional(records.photons()[nearest.front().index].power);
}

glm::dvec3 gatherRadiance(const PhotonMap& map, const VisiblePoint& x, double radius, std::uint32_t maxDepth,
                          double surfaceError) {
    const Receiver receiver = receiverAt(x);
    glm::dvec3 power(0);
    for (const std::uint32_t index : map.near(x.position, radius)) {
        const Photon& photon = map.photons()[index];
        const bool inPlane = std::abs(glm::dot(photon.position - x.position, x.geometricNormal)) <= radius / 4;
        if (inPlane && isOnSide(photon, x, surfaceError) && isWithinEdges(x, photon.position) &&
            photon.depth + x.depth <= maxDepth) {
            const double cosIn = std::clamp(glm::dot(photon.direction, x.normal), 0.0, 1.0);
            power += photon.power * receiver.incident(cosIn);
        }
    }
    return receiver.f * power / discOnSurface(x, radius);
}

} // namespace hyalite::reference
