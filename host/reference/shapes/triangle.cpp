// See triangle.h.
#include "reference/shapes/triangle.h"

#include <algorithm>
#include <cmath>

namespace hyalite::reference {

namespace {

// a.x b.y - a.y b.x with the sign of the exact value (zero if that is zero): next to a vertex shared by many triangles,
// a wrong sign would count one of them twice or not at all.
double determinant(const glm::dvec3& a, const glm::dvec3& b) {
    const double plus = a.x * b.y;
    const double minus = a.y * b.x;
    const double difference = plus - minus;
    if (std::abs(difference) > 4 * 0x1p-53 * (std::abs(plus) + std::abs(minus))) {
        return difference; // three roundings cannot have flipped its sign
    }
    // Kahan's algorithm: accurate to two ulps [Jeannerod13].
    const double error = std::fma(-a.y, b.x, minus);
    return std::fma(a.x, b.y, -minus) + error;
}

// The sign of determinant(a - m, b - m) for an infinitely small m = (e, e^2): of
// determinant(a, b) + e (a.y - b.y) + e^2 (b.x - a.x).
int movedSign(double determinant, const glm::dvec3& a, const glm::dvec3& b) {
    for (const double term : {determinant, a.y - b.y, b.x - a.x}) {
        if (term != 0) {
            return term > 0 ? 1 : -1;
        }
    }
    return 0;
}

// Twice the signed areas spanned by the line and the edge opposite to each corner.
glm::dvec3 edgeAreas(const std::array<glm::dvec3, 3>& p) {
    return {determinant(p[2], p[1]), determinant(p[0], p[2]), determinant(p[1], p[0])};
}

} // namespace

ShearedLine::ShearedLine(const Ray& ray) : origin_(ray.origin) {
    const glm::dvec3 magnitude = glm::abs(ray.direction);
    kz_ = magnitude.x > magnitude.y ? (magnitude.x > magnitude.z ? 0 : 2) : (magnitude.y > magnitude.z ? 1 : 2);
    kx_ = (kz_ + 1) % 3;
    ky_ = (kz_ + 2) % 3;
    along_ = ray.direction[kz_];
    shearX_ = ray.direction[kx_] / along_;
    shearY_ = ray.direction[ky_] / along_;
}

std::array<glm::dvec3, 3> ShearedLine::shear(const Triangle& triangle) const {
    std::array<glm::dvec3, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 q = triangle.corners[i] - origin_;
        p[i] = {q[kx_] - shearX_ * q[kz_], q[ky_] - shearY_ * q[kz_], q[kz_] / along_};
    }
    return p;
}

std::optional<ShearedLine::Meeting> ShearedLine::meetClosed(const Triangle& triangle) const {
    const std::array<glm::dvec3, 3> p = shear(triangle);
    const glm::dvec3 edges = edgeAreas(p);
    const bool inside = std::min({edges.x, edges.y, edges.z}) >= 0 || std::max({edges.x, edges.y, edges.z}) <= 0;
    return inside ? meeting(p, edges) : std::nullopt;
}

std::optional<ShearedLine::Meeting> ShearedLine::meetOnce(const Triangle& triangle) const {
    const std::array<glm::dvec3, 3> p = shear(triangle);
    const glm::dvec3 edges = edgeAreas(p);
    const int sign = movedSign(edges.x, p[2], p[1]);
    const bool inside = movedSign(edges.y, p[0], p[2]) == sign && movedSign(edges.z, p[1], p[0]) == sign;
    return inside ? meeting(p, edges) : std::nullopt;
}

std::optional<ShearedLine::Meeting> ShearedLine::meeting(const std::array<glm::dvec3, 3>& p,
                                                         const glm::dvec3& edges) const {
    const double sum = edges.x + edges.y + edges.z;
    if (sum == 0) { // seen edge-on
        return std::nullopt;
    }
    const double t = (edges.x * p[0].z + edges.y * p[1].z + edges.z * p[2].z) / sum;
    // The areas are positive if the corners run clockwise about the axis.
    return Meeting{.t = t, .u = edges.y / sum, .v = edges.z / sum, .fromFront = (sum > 0) == (along_ > 0)};
}

std::optional<ShapeHit> intersectTriangle(const Ray& ray, const Triangle& triangle) {
    const auto meeting = ShearedLine(ray).meetClosed(triangle);
    if (!meeting || !inRange(meeting->t, ray)) {
        return std::nullopt;
    }
    return ShapeHit{.t = meeting->t, .u = meeting->u, .v = meeting->v};
}

} // namespace hyalite::reference
