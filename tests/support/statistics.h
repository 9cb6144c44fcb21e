// Statistical tests with a stated false-alarm rate: of a mean against theory, and of counts against a distribution. A
// correct program fails with probability kFalseAlarmsOfSuite; docs/testing.md describes how that is divided.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>

namespace hyalite::testing {

// Probability that any statistical test of a correct program fails in one run of the whole suite with fresh seeds. The
// seeds are fixed: a test that has passed once always passes, and only a change to the program draws new samples.
inline constexpr double kFalseAlarmsOfSuite = 1e-4;

// Number of test cases that share it equally: at least the number that construct a FalseAlarms (tests/house counts
// them).
inline constexpr std::size_t kStatisticalTestCases = 64;

// P(|Z| > z) for a normal deviate with mean 0 and variance 1; z >= 0.
[[nodiscard]] double normalTail(double z);

// P(|T| > t) for Student's distribution; t >= 0, dof >= 1.
[[nodiscard]] double studentTail(double t, std::size_t dof);

// P(X > x) for the sum of the squares of `dof` normal deviates; x >= 0, dof >= 1.
[[nodiscard]] double chiSquareTail(double x, std::size_t dof);

// The level of each of `comparisons` independent tests that together raise a false alarm with probability `level`
// (Šidák's correction).
[[nodiscard]] double sidak(double level, std::size_t comparisons);

// Mean of independent samples and its standard error; two samples at least.
struct Estimate {
    double mean = 0;
    double standardError = 0;
};
[[nodiscard]] Estimate estimate(std::span<const double> samples);

// Result of a comparison; can be passed to CHECK directly.
struct Verdict {
    bool plausible = false;
    std::string text;

    explicit operator bool() const { return plausible; }
};
std::ostream& operator<<(std::ostream& out, const Verdict& verdict);

// Known bias of a mean, and the difference that the test must be able to detect.
struct Sharpness {
    double bias = 0; // relative bound on rounding and approximations; the caller must derive it
    double sees = 0; // a relative difference of this size certainly fails: noise that would hide it fails the test too
};

// One test case's share of the suite's false-alarm rate, divided equally among the comparisons that it announces.
class FalseAlarms {
public:
    explicit FalseAlarms(std::size_t comparisons);

    [[nodiscard]] double level() const { return level_; }

    // Tests if `expected` (not 0) is the mean of the distribution of the independent samples: Student's test.
    [[nodiscard]] Verdict mean(std::span<const double> samples, double expected, const Sharpness& sharpness);

    // Tests if `expected` (not 0) is the mean of the distribution of one sample, with the others giving its scatter.
    [[nodiscard]] Verdict draw(double sample, std::span<const double> others, double expected,
                               const Sharpness& sharpness);

    // Pearson's test of counts of independent draws, the last of which may be "none of these", against the
    // probabilities. Cells that expect fewer than 5 are pooled. A draw in a cell of probability 0 is implausible. With
    // stratified instead of independent numbers counts vary less, which only makes the test milder.
    [[nodiscard]] Verdict counts(std::span<const std::uint32_t> observed, std::span<const double> probabilities);

private:
    // Throws std::logic_error at one comparison more than announced.
    void use();
    [[nodiscard]] Verdict judge(const Estimate& e, std::size_t samples, double expected,
                                const Sharpness& sharpness) const;

    double level_;
    std::size_t left_;
};

} // namespace hyalite::testing
