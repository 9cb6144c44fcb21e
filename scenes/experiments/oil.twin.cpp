// The twin of oil.glsl: a film between two faces of the reflectance R. Waves that go through it 2 m times more than the
// first add up to Airy's 1 / (1 + F sin^2(delta / 2)) of transmitted light, F = 4 R / (1 - R)^2; the rest is reflected.
#include "scene/model/code_twin.h"

#include <cmath>
#include <numbers>

namespace {

using glm::dvec3;
using glm::dvec4;

dvec3 oil(double cosine, const dvec4& parameters) {
    const double index = parameters.y;
    const double refracted = std::asin(std::sqrt(1 - cosine * cosine) / index); // Snell
    const double R = parameters.z;
    const double F = 4 * R / ((1 - R) * (1 - R));
    const auto reflectance = [&](double wavelength) {
        const double halfDelta = 2 * std::numbers::pi / wavelength * index * parameters.x * std::cos(refracted);
        return 1 - 1 / (1 + F * std::pow(std::sin(halfDelta), 2));
    };
    return {reflectance(610), reflectance(545), reflectance(450)};
}

} // namespace

const hyalite::CodeTwin hyaliteTwin{.function = "oil", .codeHash = 0xae91b044e7962c50, .reflectance = oil};
