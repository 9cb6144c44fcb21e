// One stage's comparison: element by element, field by field, with what was found.
#pragma once

#include "parity/answer.h"
#include "parity/nudge.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hyalite::parity {

inline constexpr std::size_t kOffendersKept = 8; // of a field
inline constexpr std::size_t kUlpsKept = 1U << 20U;
inline constexpr std::uint64_t kFailuresExplained = 64; // that explanations are sought for with all nudges
inline constexpr int kLeastExponent = -30;              // of the histogram's first bin
inline constexpr std::size_t kBins = 32;

// Of the elements of a stage, at most this share may differ by what a few roundings of the input explain.
inline constexpr double kMostApart = 0.02;

using OffenderInputs = std::vector<std::pair<std::string, std::string>>; // name and value

struct Offender {
    std::string where; // pass, dispatch and thread
    std::string field; // that differed first
    OffenderInputs inputs;
    struct Value {
        std::string_view field;
        std::string device;
        std::string twin;
    };
    std::vector<Value> answers; // of both sides, all fields
    double error = 0;           // over the tolerance; exact fields: infinite
    std::string cause;          // empty: no few roundings of the input explain it
};

struct FieldResult {
    const Field* field = nullptr;
    std::uint64_t compared = 0;
    std::uint64_t matched = 0; // equal or within tolerance
    std::uint64_t apart = 0;   // explained by a few roundings of the input
    std::uint64_t failed = 0;
    // Of what matched or failed
    double largestUlp = 0;
    double largestRelative = 0;
    std::vector<float> ulps; // of every one or, of more than kUlpsKept, of some by chance; sorted by Capture::finish
    std::array<std::uint64_t, kBins> histogram{}; // of relative errors by power of two; first: smaller, last: larger
    std::vector<Offender> offenders;              // the worst, worst first

    void addError(const FieldError& error);
    [[nodiscard]] double ulpPercentile(double share) const; // once they are sorted
};

struct StageResult {
    std::string name;
    std::uint64_t order = 0; // of its first dispatch
    std::uint64_t dispatches = 0;
    std::uint64_t firstFailure = 0; // number of the first dispatch that failed; 0: none did
    std::uint64_t elements = 0;
    std::uint64_t apart = 0;
    std::uint64_t failed = 0;
    std::vector<FieldResult> fields;
    std::string withoutTwin; // the scene's own code that it runs and that has no twin; empty: none

    [[nodiscard]] bool hasTwin() const { return !fields.empty() && withoutTwin.empty(); }
    [[nodiscard]] double shareApart() const { return elements == 0 ? 0 : double(apart) / double(elements); }
    // Where it stands among the stages that failed.
    [[nodiscard]] std::uint64_t failureOrder() const { return firstFailure > 0 ? firstFailure : order; }
    [[nodiscard]] bool passed() const { return hasTwin() && failed == 0 && shareApart() <= kMostApart; }
};

// What became of one element.
enum class Outcome { Matched, Apart, Failed };

class Comparison {
public:
    using Twin = std::function<Answer(Nudge)>;
    using Inputs = std::function<OffenderInputs()>;

    // `fields`: all that answers may have; references to them are kept.
    Comparison(std::string stage, std::span<const Field* const> fields, double sceneScale);

    // Compares the answer of thread `i` of a dispatch with the twin's; where they differ, asks the twin about inputs
    // nearby. Throws std::logic_error where an answer has a field that is not among those compared.
    Outcome compare(const std::string& dispatch, std::size_t i, const Answer& device, const Twin& twin,
                    const Inputs& inputs);
    // The same where no rounding of the input can matter.
    Outcome compareExact(const std::string& dispatch, std::size_t i, const Answer& device, const Answer& expected);

    [[nodiscard]] StageResult& result() { return result_; }

private:
    [[nodiscard]] FieldResult* firstDifference(const Answer& device, const Answer& twin);
    [[nodiscard]] bool isExplained(const Answer& device, const Twin& twin, std::uint32_t nudges) const;
    void requireFields(const Answer& answer) const;
    Outcome conclude(const std::string& dispatch, std::size_t i, const Answer& device, const Answer& expected,
                     FieldResult& different, bool explained, const Inputs& inputs);
    void count(const Answer& device, const Answer& twin, const FieldResult* different, bool explained);
    [[nodiscard]] bool exactFieldsAgree(const Answer& device, const Answer& twin) const;
    static void keep(FieldResult& field, Offender offender, const std::function<void(Offender&)>& tell);

    StageResult result_;
    double sceneScale_;
};

[[nodiscard]] std::string describe(const glm::dvec3& v);
[[nodiscard]] std::string describe(double x);

} // namespace hyalite::parity
