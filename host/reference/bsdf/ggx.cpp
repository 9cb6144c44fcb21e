#include "reference/bsdf/ggx.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hyalite::reference {

using std::numbers::pi;

double ggxDistribution(const glm::dvec3& m, double alpha) {
    if (m.z <= 0) {
        return 0;
    }
    const double alpha2 = alpha * alpha;
    const double d = m.z * m.z * (alpha2 - 1) + 1;
    return alpha2 / (pi * d * d);
}

double smithLambda(const glm::dvec3& w, double alpha) {
    const double tan2 = std::max(0.0, 1 - w.z * w.z) / (w.z * w.z);
    return (std::sqrt(1 + alpha * alpha * tan2) - 1) / 2;
}

double smithG1(const glm::dvec3& w, double alpha) {
    return 1 / (1 + smithLambda(w, alpha));
}

double visibleNormalDensity(const glm::dvec3& wo, const glm::dvec3& m, double alpha) {
    return std::max(0.0, glm::dot(wo, m)) * ggxDistribution(m, alpha) * smithG1(wo, alpha) / wo.z;
}

glm::dvec3 sampleVisibleNormal(const glm::dvec3& wo, double alpha, glm::dvec2 uv) {
    // Stretched by 1 / alpha, the facets become those of a hemisphere. Seen from v, its normals lie halfway between v
    // and directions uniform on the spherical cap z > -v.z.
    const glm::dvec3 v = glm::normalize(glm::dvec3(alpha * wo.x, alpha * wo.y, wo.z));
    const double phi = 2 * pi * uv.x;
    const double z = 1 - uv.y * (1 + v.z);
    const double sine = std::sqrt(std::max(0.0, 1 - z * z));
    const glm::dvec3 h = v + glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), z);
    return glm::normalize(glm::dvec3(alpha * h.x, alpha * h.y, h.z));
}

} // namespace hyalite::reference
