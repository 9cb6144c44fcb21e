// See spot.h.
#include "reference/lights/spot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hyalite::reference {

namespace {

using std::numbers::pi;

struct Cone {
    double inner; // cosines
    double outer;

    explicit Cone(const SpotLight& spot)
        : inner(std::cos(spot.angle * (1 - spot.blend) * pi / 180)), outer(std::cos(spot.angle * pi / 180)) {}

    // Integral of s over c; that of t^2 (3 - 2 t) over t is 1/2.
    [[nodiscard]] double integral() const { return (1 - inner) + (inner - outer) / 2; }

    [[nodiscard]] double profile(double c) const {
        if (c >= inner) {
            return 1;
        }
        if (c <= outer) {
            return 0;
        }
        const double t = (c - outer) / (inner - outer);
        return t * t * (3 - 2 * t);
    }

    // The cosine above which s has the fraction x of its integral; by bisection between the cones.
    [[nodiscard]] double quantile(double x) const {
        const double above = x * integral();
        if (above <= 1 - inner) {
            return 1 - above;
        }
        const double share = 1 - (above - (1 - inner)) / ((inner - outer) / 2); // of the falling part, below c
        double low = 0;
        double high = 1;
        for (int i = 0; i < 60; ++i) {
            const double t = (low + high) / 2;
            (2 * t * t * t - t * t * t * t < share ? low : high) = t; // the integral of 2 t^2 (3 - 2 t)
        }
        return outer + low * (inner - outer);
    }
};

glm::dvec3 sampleSpot(const SpotLight& spot, glm::dvec2 uv) {
    const double cosine = Cone(spot).quantile(uv.x);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double phi = 2 * pi * uv.y;
    const Basis basis = orthonormalBasis(spot.direction);
    return sine * std::cos(phi) * basis.tangent + sine * std::sin(phi) * basis.bitangent + cosine * spot.direction;
}

} // namespace

Offer offerTo(const glm::dvec3& receiver, const SpotLight& light, glm::dvec2 /*uv*/) {
    const double cosine = glm::dot(light.direction, glm::normalize(receiver - light.position));
    return offerFrom(light.position, receiver, light.intensity * Cone(light).profile(cosine));
}

double pdfToward(const SpotLight& /*light*/, const glm::dvec3& /*direction*/, double /*distance*/,
                 const glm::dvec3& /*lightNormal*/) {
    return 0;
}

LightRay emitFrom(const SpotLight& light, glm::dvec2 /*uOrigin*/, glm::dvec2 uDirection) {
    const glm::dvec3 direction = sampleSpot(light, uDirection);
    return {.origin = light.position,
            .direction = direction,
            .pdfDirection = emissionDensity(light, glm::dvec3(0), direction)};
}

double emissionDensity(const SpotLight& light, const glm::dvec3& /*normal*/, const glm::dvec3& direction) {
    const Cone cone(light);
    return cone.profile(glm::dot(light.direction, direction)) / (2 * pi * cone.integral());
}

double emissionCosine(const SpotLight& light) {
    return std::cos(glm::radians(light.angle));
}

std::optional<StartDisc> startDisc(const SpotLight& /*light*/) {
    return std::nullopt;
}

glm::dvec3 fluxOf(const SpotLight& light) {
    return 2 * pi * Cone(light).integral() * light.intensity;
}

} // namespace hyalite::reference
