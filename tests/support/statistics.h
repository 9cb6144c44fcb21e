// Tests by chance with a stated rate of false alarms: is a mean what theory says, do counts follow a distribution. A
// wrong verdict on a correct program is as rare as kFalseAlarmsOfSuite, and docs/testing.md says how that is divided.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>

namespace hyalite::testing {

// Probability that any statistical test fails although all is right, in one run of the whole suite with fresh seeds.
// The seeds are fixed: what has passed once passes always, and only a change to the program draws new samples.
inline constexpr double kFalseAlarmsOfSuite = 1e-4;

// Test cases that share it evenly: at least as many as make a FalseAlarms (tests/house counts them).
inline constexpr std::size_t kStatisticalTestCases = 64;

// P(|Z| > z) of a normal deviate with mean 0 and variance 1; z >= 0.
[[nodiscard]] double normalTail(double z);

// P(|T| > t) of Student's distribution; t >= 0, dof >= 1.
[[nodiscard]] double studentTail(double t, std::size_t dof);

// P(X > x) of the sum of the squares of `dof` normal deviates; x >= 0, dof >= 1.
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

// What a comparison says; CHECK takes it as it stands.
struct Verdict {
    bool plausible = false;
    std::string text;

    explicit operator bool() const { return plausible; }
};
std::ostream& operator<<(std::ostream& out, const Verdict& verdict);

// By how much a mean may differ from theory for known reasons, and which difference the test must be able to see.
struct Sharpness {
    double bias = 0; // bound of rounding and of approximations; relative, to be derived by who states it
    double sees = 0; // a difference of this much, relative, fails surely: noise that would hide it fails the test too
};

// The share of one test case in the false alarms of the suite, divided evenly over the comparisons that it announces.
class FalseAlarms {
public:
    explicit FalseAlarms(std::size_t comparisons);

    [[nodiscard]] double level() const { return level_; }

    // Is `expected` (not 0) the mean of what the independent samples are drawn from? Student's test.
    [[nodiscard]] Verdict mean(std::span<const double> samples, double expected, const Sharpness& sharpness);

    // Is `expected` (not 0) the mean of what one sample is drawn from, which scatters like the others?
    [[nodiscard]] Verdict draw(double sample, std::span<const double> others, double expected,
                               const Sharpness& sharpness);

    // Pearson's test: do counts of independent draws, the last of which may be "none of these", follow the
    // probabilities? Cells that expect fewer than 5 are pooled. A draw in a cell of probability 0 is not plausible.
    // Evenly spread numbers in place of independent ones make counts vary less, and this test only milder.
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
