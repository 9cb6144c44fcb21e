// Inputs moved by a few roundings: the twin's results for them show whether rounding explains a difference.
#pragma once

#include "shaders/shared/random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace hyalite::parity {

// Largest move of an input that may explain a difference, in units of 2^-24 of the largest coordinate involved: a
// kernel performs some dozens of operations between its input and a decision.
inline constexpr double kNudge = 16;

// Number of nearby inputs tried where the two sides differ; and the larger number tried where a moved ray seldom hits
// the same sliver of a triangle again.
inline constexpr std::uint32_t kNudges = 48;
inline constexpr std::uint32_t kMoreNudges = 480;

[[nodiscard]] inline double largestComponent(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

class Nudge {
public:
    // Number 0 moves nothing; 1 … kNudges move by different random amounts of up to kNudge roundings.
    explicit Nudge(std::uint32_t number) : number_(number) {
        const double sizes[] = {kNudge / 8, kNudge / 2, kNudge};
        reach_ = number == 0 ? 0 : 0x1p-24 * sizes[number % 3];
    }

    [[nodiscard]] bool movesNothing() const { return number_ == 0; }

    // `scale` [m]: the largest coordinate from which the point was computed.
    [[nodiscard]] glm::dvec3 point(const glm::dvec3& p, double scale) {
        return p + (reach_ * std::max(scale, largestComponent(p))) * random();
    }
    [[nodiscard]] glm::dvec3 direction(const glm::dvec3& d) { return glm::normalize(d + reach_ * random()); }
    // Shift for random numbers in [0, 1): the device compares them with float thresholds, the twin with double ones.
    [[nodiscard]] double shift() { return reach_ * random().x; }
    [[nodiscard]] double number(double x) { return x * (1 + reach_ * random().x); }

private:
    // Uniform in the cube [-1, 1]^3, a new point on each call.
    [[nodiscard]] glm::dvec3 random() {
        glm::dvec3 v;
        for (int i = 0; i < 3; ++i) {
            v[i] = shared::hashCombine(number_, ++drawn_) * 0x1p-31 - 1;
        }
        return v;
    }

    std::uint32_t number_;
    std::uint32_t drawn_ = 0;
    double reach_;
};

} // namespace hyalite::parity
