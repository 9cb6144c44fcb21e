// Number of rays of a test where more rays only find rarer faults.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace hyalite::testing {

// `most` of them in scripts/test.sh thorough, else a quarter.
inline std::uint32_t manyRays(std::uint32_t most) {
    const bool all = std::getenv("HYALITE_THOROUGH") != nullptr; // NOLINT(concurrency-mt-unsafe): nobody sets it
    return all ? most : most / 4;
}

} // namespace hyalite::testing
