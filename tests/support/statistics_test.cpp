// The statistics that other tests rely on, against closed forms and by simulation.
#include "support/statistics.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

namespace hyalite::testing {

namespace {

// 16 normal deviates; the same on every machine but for rounding.
std::vector<double> sixteen(std::mt19937& engine, double mean) {
    std::normal_distribution<double> normal(mean, 1);
    std::vector<double> samples(16);
    for (double& sample : samples) {
        sample = normal(engine);
    }
    return samples;
}

} // namespace

TEST_CASE("the tails of distributions are their closed forms") {
    // Student, 1: Cauchy, 1 - 2/pi atan t; 2: 1 - t / sqrt(2 + t^2); 3: 1 - 2/pi (theta + sin theta cos theta)
    for (const double t : {0.0, 0.3, 1.0, 4.0, 50.0}) {
        CHECK(std::abs(studentTail(t, 1) - (1 - 2 / std::numbers::pi * std::atan(t))) < 1e-14);
        CHECK(std::abs(studentTail(t, 2) - (1 - t / std::sqrt(2 + t * t))) < 1e-14);
        const double theta = std::atan(t / std::sqrt(3.0));
        CHECK(std::abs(studentTail(t, 3) - (1 - 2 / std::numbers::pi * (theta + std::sin(theta) * std::cos(theta)))) <
              1e-14);
        // Chi square, 1: |Z| > sqrt x; 2: e^(-x/2); 4: (1 + x/2) e^(-x/2)
        CHECK(std::abs(chiSquareTail(t, 1) - normalTail(std::sqrt(t))) < 1e-14);
        CHECK(std::abs(chiSquareTail(t, 2) - std::exp(-t / 2)) < 1e-14);
        CHECK(std::abs(chiSquareTail(t, 4) - (1 + t / 2) * std::exp(-t / 2)) < 1e-14);
    }
    // Many degrees of freedom: Student's becomes normal, off by about t^4 / (4 dof) of the density
    CHECK(std::abs(studentTail(2, 100001) - normalTail(2)) < 1e-5);
    // Wilson and Hilferty: (x / n)^(1/3) is almost normal with mean 1 - 2 / (9 n) and variance 2 / (9 n)
    const double n = 301;
    const double z = 2;
    const double x = n * std::pow(1 - 2 / (9 * n) + z * std::sqrt(2 / (9 * n)), 3);
    CHECK(std::abs(chiSquareTail(x, 301) - normalTail(z) / 2) < 1e-4);
}

TEST_CASE("several tests at Sidak's level together raise a false alarm as rarely as one") {
    CHECK(std::abs(1 - std::pow(1 - sidak(0.05, 20), 20) - 0.05) < 1e-14);
    CHECK(std::abs(sidak(1e-12, 1000) - 1e-15) < 1e-26);
    FalseAlarms alarms(3);
    const double all = 1 - std::pow(1 - alarms.level(), 3.0 * static_cast<double>(kStatisticalTestCases));
    CHECK(std::abs(all - kFalseAlarmsOfSuite) < 1e-12);
}

TEST_CASE("a mean that is off by ten standard errors is refused, a right one is not, and a blunt test is, of many "
          "samples and of one") {
    std::mt19937 engine(1);
    FalseAlarms alarms(4);
    // A standard error of 1/4 about a mean of 100
    CHECK(alarms.mean(sixteen(engine, 100), 100, {.sees = 0.05}));
    CHECK_FALSE(alarms.mean(sixteen(engine, 105), 100, {.sees = 0.05}));
    CHECK(alarms.mean(sixteen(engine, 105), 100, {.bias = 0.055, .sees = 0.1}));
    CHECK_FALSE(alarms.mean(sixteen(engine, 100), 100, {.sees = 0.001}));
    FalseAlarms draws(3);
    CHECK(draws.draw(sixteen(engine, 100)[0], sixteen(engine, 100), 100, {.sees = 0.2}));
    CHECK_FALSE(draws.draw(120, sixteen(engine, 100), 100, {.sees = 0.2}));
    CHECK_FALSE(draws.draw(100, sixteen(engine, 100), 100, {.sees = 0.02}));
    CHECK_THROWS_AS(alarms.mean(sixteen(engine, 100), 100, {.sees = 0.05}), std::logic_error);
}

TEST_CASE("without noise a mean must be within the bias, or is rejected") {
    FalseAlarms alarms(2);
    const std::array<double, 3> samples{1, 1, 1};
    CHECK(alarms.mean(samples, 1 + 1e-7, {.bias = 1e-6, .sees = 1e-5}));
    CHECK_FALSE(alarms.mean(samples, 1 + 1e-5, {.bias = 1e-6, .sees = 1e-3}));
}

TEST_CASE("Student's test of sixteen normal deviates is wrong one time in a hundred at that level") {
    // 20 000 tests at level 0.01: 200 alarms, standard deviation 14; five of them
    std::mt19937 engine(2);
    int ofMeans = 0;
    int ofDraws = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::vector<double> samples = sixteen(engine, 0);
        const Estimate e = estimate(samples);
        ofMeans += studentTail(std::abs(e.mean) / e.standardError, 15) < 0.01 ? 1 : 0;
        // One sample more, by the scatter of the sixteen: 4 standard errors is their deviation
        ofDraws += studentTail(std::abs(sixteen(engine, 0)[0]) / (4 * e.standardError), 15) < 0.01 ? 1 : 0;
    }
    CHECK(std::abs(ofMeans - 200) < 70);
    CHECK(std::abs(ofDraws - 200) < 70);
}

TEST_CASE("counts of a fair die are plausible, of a loaded one not") {
    const auto roll = [](const std::vector<double>& weights) {
        std::mt19937 engine(3);
        std::discrete_distribution<std::size_t> die(weights.begin(), weights.end());
        std::vector<std::uint32_t> counts(weights.size());
        for (int i = 0; i < 60000; ++i) {
            ++counts[die(engine)];
        }
        return counts;
    };
    FalseAlarms alarms(6);
    const std::vector<double> fair(6, 1.0 / 6);
    CHECK(alarms.counts(roll({1, 1, 1, 1, 1, 1}), fair));
    // 10 % more sixes: chi^2 is about 10 000 (0.1^2 + 5 (0.02)^2) = 120 of 5 degrees
    CHECK_FALSE(alarms.counts(roll({1, 1, 1, 1, 1, 1.1}), fair));
    // Cells of 1e-5 expect 0.6 each: pooled, ten of them expect 6
    std::vector<double> rare(11, 1e-5);
    rare[0] = 1 - 1e-4;
    CHECK(alarms.counts(roll(rare), rare));
    // 30 where 0.6 are expected
    CHECK_FALSE(alarms.counts(std::array<std::uint32_t, 3>{30000, 30000, 30}, std::array{0.5 - 1e-5, 0.5, 1e-5}));
    // One draw where none can be
    CHECK_FALSE(alarms.counts(std::array<std::uint32_t, 3>{5000, 5000, 1}, std::array{0.5, 0.5, 0.0}));
    // Counts with only one cell prove nothing
    CHECK_FALSE(alarms.counts(std::array<std::uint32_t, 1>{100}, std::array{1.0}));
}

} // namespace hyalite::testing
