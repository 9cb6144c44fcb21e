// See torus.h.
#include "reference/shapes/torus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace hyalite::reference {

namespace {

using glm::dvec3;
using Complex = std::complex<double>;

// All roots of s^4 + c[2] s^2 + c[1] s + c[0], up to rounding; multiple roots appear as clusters around the true root.
std::array<Complex, 4> quarticRoots(const std::array<double, 3>& c) {
    // Each root takes a Newton step, corrected for the other roots.
    const double radius = 1 + std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2])}); // Cauchy's bound
    std::array<Complex, 4> roots{};
    for (std::size_t i = 0; i < roots.size(); ++i) { // on a circle, not symmetric about the real axis
        roots.at(i) = std::polar(radius / 2, 0.4 + 1.5 * static_cast<double>(i));
    }
    constexpr int kIterations = 100; // usually ten suffice; at multiple roots the error only halves per step
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        double moved = 0;
        for (Complex& root : roots) {
            const Complex value = ((root * root + c[2]) * root + c[1]) * root + c[0];
            const Complex slope = (4.0 * root * root + 2 * c[2]) * root + c[1];
            Complex pull = 0;
            for (const Complex& other : roots) {
                pull += other == root ? 0.0 : 1.0 / (root - other);
            }
            const Complex denominator = slope - value * pull;
            const Complex step = denominator == 0.0 ? Complex(0) : value / denominator;
            root -= step;
            moved = std::max(moved, std::abs(step));
        }
        if (moved < 0x1p-50 * radius) {
            break;
        }
    }
    return roots;
}

// A line in the torus's object space, parameterised by the distance s from its point nearest to the centre, in units of
// the major radius.
struct TorusLine {
    dvec3 nearest;
    dvec3 direction; // unit
    double minor = 0;

    struct Value {
        double value = 0; // squared distance from the tube's centre circle minus minor^2: negative inside
        double slope = 0; // along s
    };
    [[nodiscard]] Value at(double s) const {
        const dvec3 p = nearest + s * direction;
        const double rho = std::hypot(p.x, p.z);
        const double rhoSlope = rho > 0 ? (p.x * direction.x + p.z * direction.z) / rho : 0;
        return {(rho - 1) * (rho - 1) + p.y * p.y - minor * minor, 2 * ((rho - 1) * rhoSlope + p.y * direction.y)};
    }
    // With |p|^2 = s^2 + |nearest|^2 (nearest is perpendicular to the direction) the torus (|p|^2 + 1 - minor^2)^2 = 4
    // (|p|^2 - y^2) has no cubic term.
    [[nodiscard]] std::array<double, 3> quartic() const {
        const double k = glm::dot(nearest, nearest) + 1 - minor * minor;
        return {k * k - 4 * (nearest.x * nearest.x + nearest.z * nearest.z), 8 * nearest.y * direction.y,
                2 * k - 4 * (1 - direction.y * direction.y)};
    }
};

// The root between two places of opposite sign: Newton steps while they stay inside and converge, bisection otherwise.
double polish(const TorusLine& line, double low, double high) {
    const bool lowInside = line.at(low).value <= 0;
    double s = (low + high) / 2;
    double lastStep = high - low;
    constexpr int kSteps = 200; // bisection alone needs about sixty
    for (int i = 0; i < kSteps; ++i) {
        const auto [value, slope] = line.at(s);
        ((value <= 0) == lowInside ? low : high) = s;
        double next = s - value / slope;
        if (!(next > low && next < high) || std::abs(next - s) > lastStep / 2) {
            next = (low + high) / 2;
        }
        lastStep = std::abs(next - s);
        if (next == s || next == low || next == high) {
            break;
        }
        s = next;
    }
    return s;
}

dvec3 circlePoint(const WorldTorus& torus, const dvec3& p) {
    const double rho = std::hypot(p.x, p.z);
    return rho > 0 ? torus.major / rho * dvec3(p.x, 0, p.z) : dvec3(torus.major, 0, 0);
}

} // namespace

Crossings crossings(const WorldTorus& torus, const Ray& line) {
    const Ray object = torus.map.rayToObject(line);
    const double speed = glm::length(object.direction);
    const dvec3 direction = object.direction / speed;
    const double start = -glm::dot(object.origin, direction);
    const TorusLine unit{.nearest = (object.origin + start * direction) / torus.major,
                         .direction = direction,
                         .minor = torus.minor / torus.major};
    const double reach = 1 + unit.minor;
    if (glm::length(unit.nearest) >= reach) {
        return {};
    }
    std::array<double, 4> roots{};
    std::ranges::transform(quarticRoots(unit.quartic()), roots.begin(), [](const Complex& z) { return z.real(); });
    std::ranges::sort(roots);
    // The sign is constant between two roots, so the midpoint determines it.
    const std::array places{-2 * reach, (roots[0] + roots[1]) / 2, (roots[1] + roots[2]) / 2, (roots[2] + roots[3]) / 2,
                            2 * reach};
    Crossings result;
    bool inside = false;
    for (std::size_t i = 1; i < places.size(); ++i) {
        if ((unit.at(places.at(i)).value <= 0) != inside) {
            inside = !inside;
            const double s = polish(unit, places.at(i - 1), places.at(i));
            result.push_back({.at = {.t = (s * torus.major + start) / speed}, .entering = inside});
        }
    }
    return result;
}

bool isInside(const WorldTorus& torus, const dvec3& point) {
    const dvec3 p = torus.map.pointToObject(point);
    return glm::length(p - circlePoint(torus, p)) <= torus.minor;
}

SurfacePoint surfaceAt(const WorldTorus& torus, const Ray& ray, const ShapeHit& hit) {
    const dvec3 near = torus.map.pointToObject(ray.origin + hit.t * ray.direction);
    const dvec3 circle = circlePoint(torus, near);
    const dvec3 outward = glm::normalize(near - circle);
    SurfacePoint point{};
    point.position = torus.map.pointToWorld(circle + torus.minor * outward);
    point.geometricNormal = glm::normalize(torus.map.normalToWorld(outward));
    point.normal = point.geometricNormal;
    point.offset = surfaceOffset(roundingScale(torus.map, point.position, torus.major + torus.minor, outward));
    return point;
}

} // namespace hyalite::reference
