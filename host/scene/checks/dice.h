// Random numbers of the checks: the same in every run.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace hyalite::checks {

class Dice {
public:
    // In [0, 1). SplitMix64 [Steele14].
    double next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
        z = (z ^ z >> 30U) * 0xbf58476d1ce4e5b9U;
        z = (z ^ z >> 27U) * 0x94d049bb133111ebU;
        return static_cast<double>((z ^ z >> 31U) >> 11U) * 0x1p-53;
    }
    glm::dvec2 pair() {
        const double x = next();
        return {x, next()};
    }
    // Below `count`, which is at least 1.
    std::size_t index(std::size_t count) { return static_cast<std::size_t>(next() * static_cast<double>(count)); }

private:
    std::uint64_t state_ = 1;
};

} // namespace hyalite::checks
