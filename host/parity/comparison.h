// The comparison of one stage, element by element and field by field, and its result.
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

inline constexpr std::size_t kOffendersKept = 8; // per field
inline constexpr std::size_t kUlpsKept = 1U << 20U;
inline constexpr std::uint64_t kFailuresExplained = 64; // of a stage, for which all nudges are tried
inline constexpr int kLeastExponent = -30;              // power of two of the histogram's first bin
inline constexpr std::size_t kBins = 32;

// Largest share of a stage's elements that may differ by what a few roundings of the input explain.
inline constexpr double kMostApart = 0.02;

using OffenderInputs = std::vector<std::pair<std::string, std::string>>; // name and value

struct Offender {
    std::string where; // pass, dispatch and thread
    std::string field; // the first that differed
    OffenderInputs inputs;
    struct Value {
        std::string_view field;
        std::string device;
        std::string twin;
    };
    std::vector<Value> answers; // of both sides, for all fields
    double error = 0;           // relative to the tolerance; infinite for exact fields
    std::string cause;          // empty: no few roundings of the input explain it
};

struct FieldResult {
    const Field* field = nullptr;
    std::uint64_t compared = 0;
    std::uint64_t matched = 0; // equal or within tolerance
    std::uint64_t apart = 0;   // explained by a few roundings of the input
    std::uint64_t failed = 0;
    // Over the elements that matched or failed
    double largestUlp = 0;
    double largestRelative = 0;
    std::vector<float> ulps; // of every element or, above kUlpsKept, of a random sample; sorted by Capture::finish
    std::array<std::uint64_t, kBins> histogram{}; // of relative errors by power of two; end bins are open
    std::vector<Offender> offenders;              // the worst first

    void addError(const FieldError& error);
    [[nodiscard]] double ulpPercentile(double share) const; // requires sorted ulps
};

struct StageResult {
    std::string name;
    std::uint64_t order = 0; // number of its first dispatch
    std::uint64_t dispatches = 0;
    std::uint64_t firstFailure = 0; // number of the first dispatch that failed; 0: none failed
    std::uint64_t elements = 0;
    std::uint64_t apart = 0;
    std::uint64_t failed = 0;
    std::vector<FieldResult> fields;
    std::string withoutTwin; // the scene's GLSL code that it runs and that has no twin; empty: none

    [[nodiscard]] bool hasTwin() const { return !fields.empty() && withoutTwin.empty(); }
    [[nodiscard]] double shareApart() const { return elements == 0 ? 0 : double(apart) / double(elements); }
    // Sort key among the stages that failed.
    [[nodiscard]] std::uint64_t failureOrder() const { return firstFailure > 0 ? firstFailure : order; }
    [[nodiscard]] bool passed() const { return hasTwin() && failed == 0 && shareApart() <= kMostApart; }
};

// Result for one element.
enum class Outcome { Matched, Apart, Failed };

class Comparison {
public:
    using Twin = std::function<Answer(Nudge)>;
    using Inputs = std::function<OffenderInputs()>;

    // `fields`: all fields that answers may have. Keeps references to them.
    Comparison(std::string stage, std::span<const Field* const> fields, double sceneScale);

    // Compares the answer of thread `i` of a dispatch with the twin's; if they differ, evaluates the twin at nearby
    // inputs. Throws std::logic_error if an answer has a field that is not in `fields`.
    Outcome compare(const std::string& dispatch, std::size_t i, const Answer& device, const Twin& twin,
                    const Inputs& inputs);
    // The same for results that no rounding of the input can change.
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
