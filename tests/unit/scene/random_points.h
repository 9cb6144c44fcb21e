// Random points for tests that compare formulas at many places; the seed is fixed, so that a failure repeats.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <random>

namespace hyalite::test {

class RandomPoints {
public:
    explicit RandomPoints(std::uint32_t seed) : random_(seed) {}

    double unit() { return static_cast<double>(random_()) / 4294967296.0; } // [0, 1)

    glm::dvec3 inCube(double half) {
        const double x = unit();
        const double y = unit();
        const double z = unit();
        return half * (2.0 * glm::dvec3(x, y, z) - 1.0);
    }

private:
    std::mt19937 random_; // its numbers, unlike the distributions', are the same with every library
};

} // namespace hyalite::test
