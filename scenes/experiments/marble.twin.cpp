// The twin of marble.glsl: veins where a coordinate, bent by noise, passes a half.
#include "scene/model/code_twin.h"
#include "shaders/shared/random.h"

#include <algorithm>
#include <cmath>

namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
namespace shared = hyalite::shared;

double cornerValue(const dvec3& corner) {
    const auto word = [](double x) { return static_cast<std::uint32_t>(static_cast<std::int32_t>(x)); };
    const std::uint32_t bits =
        shared::hashCombine(shared::hashCombine(shared::hash(word(corner.x)), word(corner.y)), word(corner.z));
    return static_cast<double>(bits >> 8U) * 0x1p-24;
}

double valueNoise(const dvec3& p) {
    const dvec3 corner = glm::floor(p);
    const dvec3 f = p - corner;
    const dvec3 w = f * f * (3.0 - 2.0 * f);
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const dvec3 step(i & 1, i >> 1 & 1, i >> 2);
        const dvec3 share = glm::mix(1.0 - w, w, step);
        sum += share.x * share.y * share.z * cornerValue(corner + step);
    }
    return sum;
}

dvec3 marble(const dvec3& position, const dvec2& /*uv*/, const dvec4& parameters) {
    const dvec3 p = position * parameters.x;
    double turbulence = 0;
    double scale = 1;
    for (int octave = 0; octave < 4; ++octave) {
        turbulence += (valueNoise(p * scale) - 0.5) / scale;
        scale *= 2;
    }
    const double along = p.x + p.y + parameters.y * turbulence;
    const double distance = std::abs(along - std::floor(along) - 0.5);
    const double vein = std::max(0.0, 1 - distance * parameters.z);
    return glm::mix(dvec3(0.85, 0.83, 0.8), dvec3(0.12, 0.13, 0.18), vein * vein);
}

} // namespace

const hyalite::CodeTwin hyaliteTwin{.function = "marble", .codeHash = 0x743438eabf6e8cc3, .texture = marble};
