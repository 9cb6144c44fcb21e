// The maps of the unit square, written as the papers give them.
#include "reference/lib/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hyalite::reference {

using std::numbers::pi;

double toUnit(std::uint32_t bits) {
    return static_cast<double>(bits >> 8U) * 0x1p-24;
}

glm::dvec2 sampleUnitSquare(const shared::Sampler& sampler, std::uint32_t dimension, double shift) {
    const glm::uvec2 bits = shared::sampleBits(sampler, dimension);
    return glm::clamp(glm::dvec2(toUnit(bits.x), toUnit(bits.y)) + shift, 0.0, 1 - 0x1p-24);
}

glm::dvec2 concentricDisc(glm::dvec2 uv) {
    const double a = 2 * uv.x - 1;
    const double b = 2 * uv.y - 1;
    if (a == 0 && b == 0) {
        return {0, 0};
    }
    if (std::abs(a) > std::abs(b)) {
        const double phi = pi / 4 * (b / a);
        return {a * std::cos(phi), a * std::sin(phi)};
    }
    const double phi = pi / 4 * (a / b);
    return {b * std::sin(phi), b * std::cos(phi)};
}

Basis orthonormalBasis(const glm::dvec3& n) {
    const double sign = n.z < 0 ? -1.0 : 1.0; // not copysign: a normal's -0 must give the same basis as +0
    const double a = -1 / (sign + n.z);
    const double b = n.x * n.y * a;
    return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

glm::dvec3 cosineHemisphere(glm::dvec2 uv, const glm::dvec3& normal) {
    const glm::dvec2 disc = concentricDisc(uv);
    const double z = std::sqrt(std::max(0.0, 1 - disc.x * disc.x - disc.y * disc.y));
    const Basis basis = orthonormalBasis(normal);
    return disc.x * basis.tangent + disc.y * basis.bitangent + z * normal;
}

glm::dvec3 uniformSphere(glm::dvec2 uv) {
    const double z = 1 - 2 * uv.x;
    const double sine = std::sqrt(std::max(0.0, 1 - z * z));
    const double phi = 2 * pi * uv.y;
    return {sine * std::cos(phi), sine * std::sin(phi), z};
}

glm::dvec3 pointOnQuad(glm::dvec2 uv, const Quad& quad) {
    return quad.corner + uv.x * quad.edge0 + uv.y * quad.edge1;
}

} // namespace hyalite::reference
