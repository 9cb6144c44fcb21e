// The check of one kernel against the reference, as one descriptor: its twin, the fields compared, the scene's code
// that it runs, and what the path recorder learns from it. Each file of checks/ defines those of a kernel or a family.
#pragma once

#include "parity/comparison.h"
#include "parity/observed.h"
#include "parity/sides.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace hyalite::parity {

class PathRecorder;

// What a comparison of one dispatch sees and fills. `where` names the dispatch; threads are added to it.
struct Stage {
    const Sides& sides;
    const Observed& seen;
    Comparison& comparison;
    std::string where;

    // Compares the element that thread `i` answers for.
    Outcome compare( // NOLINT(modernize-use-nodiscard): few ask
        std::size_t i, const Answer& device, const Comparison::Twin& twin,
        const Comparison::Inputs& inputs = [] { return OffenderInputs(); }) const {
        return comparison.compare(where, i, device, twin, inputs);
    }
    // NOLINTNEXTLINE(modernize-use-nodiscard): likewise
    Outcome compareExact(std::size_t i, const Answer& device, const Answer& expected) const {
        return comparison.compareExact(where, i, device, expected);
    }
    // The same of one integer.
    void expect(std::size_t i, const Field& field, std::uint64_t device, std::uint64_t expected) const {
        Answer a;
        a.exact(field, device);
        Answer b;
        b.exact(field, expected);
        compareExact(i, a, b);
    }
};

// Code that a scene brings along and a kernel runs, as bits: without twins of that code the kernel cannot be compared.
inline constexpr std::uint32_t kRunsTextures = 1;
inline constexpr std::uint32_t kRunsReflectances = 2;
inline constexpr std::uint32_t kRunsFilter = 4;

// What the path recorder learns from a kernel's dispatches.
struct PathNote {
    bool ofPhotons = false;                                                   // of photon paths, else of camera paths
    bool begins = false;                                                      // the dispatch may begin paths
    void (*take)(PathRecorder& recorder, const Observed& dispatch) = nullptr; // nullptr: nothing
};

struct Check {
    std::string_view kernel;                        // its name
    void (*compare)(const Stage& stage) = nullptr;  // what a dispatch wrote with what the twin says of its inputs
    std::array<std::span<const Field>, 4> fields{}; // of its answers, in the order in which they are compared
    std::uint32_t runs = 0;                         // kRuns… above
    PathNote paths{};

    template <class Visit>
    void forEachField(const Visit& visit) const {
        for (const std::span<const Field>& part : fields) {
            std::ranges::for_each(part, visit);
        }
    }
};

// For records that are copied, not computed.
template <class T>
[[nodiscard]] bool sameBits(const T& a, const T& b) {
    return std::ranges::equal(std::as_bytes(std::span(&a, 1)), std::as_bytes(std::span(&b, 1)));
}

} // namespace hyalite::parity
