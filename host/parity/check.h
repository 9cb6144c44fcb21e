// The check of one kernel against the reference, as one descriptor: its twin, the fields compared, the scene's code
// that it runs, and what it reports to the path recorder. Each file of checks/ defines the checks of a kernel or a
// family.
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

// Inputs and output of the comparison of one dispatch. `where` names the dispatch; the thread is appended to it.
struct Stage {
    const Sides& sides;
    const Observed& seen;
    Comparison& comparison;
    std::string where;

    // Compares the element computed by thread `i`.
    Outcome compare( // NOLINT(modernize-use-nodiscard): few callers need it
        std::size_t i, const Answer& device, const Comparison::Twin& twin,
        const Comparison::Inputs& inputs = [] { return OffenderInputs(); }) const {
        return comparison.compare(where, i, device, twin, inputs);
    }
    // NOLINTNEXTLINE(modernize-use-nodiscard): few callers need it
    Outcome compareExact(std::size_t i, const Answer& device, const Answer& expected) const {
        return comparison.compareExact(where, i, device, expected);
    }
    // The same for one integer.
    void expect(std::size_t i, const Field& field, std::uint64_t device, std::uint64_t expected) const {
        Answer a;
        a.exact(field, device);
        Answer b;
        b.exact(field, expected);
        compareExact(i, a, b);
    }
};

// Kinds of scene code that a kernel runs, as bits: without twins of that code the kernel cannot be compared.
inline constexpr std::uint32_t kRunsTextures = 1;
inline constexpr std::uint32_t kRunsReflectances = 2;
inline constexpr std::uint32_t kRunsFilter = 4;

// What a kernel's dispatches report to the path recorder.
struct PathNote {
    bool ofPhotons = false;                                                   // photon paths, else camera paths
    bool begins = false;                                                      // the dispatch may begin paths
    void (*take)(PathRecorder& recorder, const Observed& dispatch) = nullptr; // nullptr: nothing to report
};

struct Check {
    std::string_view kernel;                        // its name
    void (*compare)(const Stage& stage) = nullptr;  // compares a dispatch's output with the twin's for the same inputs
    std::array<std::span<const Field>, 4> fields{}; // compared fields, in order
    std::uint32_t runs = 0;                         // kRuns… above
    PathNote paths{};

    template <class Visit>
    void forEachField(const Visit& visit) const {
        for (const std::span<const Field>& part : fields) {
            std::ranges::for_each(part, visit);
        }
    }
};

// Bitwise equality, for records that are copied, not computed.
template <class T>
[[nodiscard]] bool sameBits(const T& a, const T& b) {
    return std::ranges::equal(std::as_bytes(std::span(&a, 1)), std::as_bytes(std::span(&b, 1)));
}

} // namespace hyalite::parity
