#include "support/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace hyalite::testing {

double normalTail(double z) {
    return std::erfc(z / std::numbers::sqrt2);
}

// By the finite sums for whole degrees of freedom, in the angle theta = atan(t / sqrt(dof)): the distribution's density
// is a power of its cosine, integrated by parts.
double studentTail(double t, std::size_t dof) {
    const double theta = std::atan(t / std::sqrt(static_cast<double>(dof)));
    const double cos2 = std::pow(std::cos(theta), 2);
    const bool odd = dof % 2 == 1;
    double term = odd ? std::cos(theta) : 1;
    double sum = 0;
    for (std::size_t n = odd ? 3 : 2; n <= dof; n += 2) {
        sum += term;
        term *= cos2 * static_cast<double>(n - 1) / static_cast<double>(n);
    }
    const double within = odd ? 2 / std::numbers::pi * (theta + std::sin(theta) * sum) : std::sin(theta) * sum;
    return std::max(0.0, 1 - within);
}

// Two degrees more add one term: Q(a + 1, y) = Q(a, y) + y^a e^-y / Gamma(a + 1), a = dof / 2, y = x / 2, from
// Q(1/2, y) = erfc(sqrt y) or Q(1, y) = e^-y.
double chiSquareTail(double x, std::size_t dof) {
    if (x <= 0) {
        return 1;
    }
    const double y = x / 2;
    double tail = dof % 2 == 1 ? std::erfc(std::sqrt(y)) : std::exp(-y);
    for (double a = dof % 2 == 1 ? 0.5 : 1; a < static_cast<double>(dof) / 2 - 0.25; a += 1) {
        tail +=
            std::exp(a * std::log(y) - y - std::lgamma(a + 1)); // NOLINT(concurrency-mt-unsafe): its sign is not asked
    }
    return std::min(1.0, tail);
}

double sidak(double level, std::size_t comparisons) {
    return -std::expm1(std::log1p(-level) / static_cast<double>(comparisons));
}

Estimate estimate(std::span<const double> samples) {
    const auto n = static_cast<double>(samples.size());
    const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) / n;
    double squares = 0;
    for (const double sample : samples) {
        squares += (sample - mean) * (sample - mean);
    }
    return {mean, std::sqrt(squares / (n - 1) / n)};
}

std::ostream& operator<<(std::ostream& out, const Verdict& verdict) {
    return out << verdict.text;
}

FalseAlarms::FalseAlarms(std::size_t comparisons)
    : level_(sidak(sidak(kFalseAlarmsOfSuite, kStatisticalTestCases), comparisons)), left_(comparisons) {}

void FalseAlarms::use() {
    if (left_ == 0) {
        throw std::logic_error("the test case makes more comparisons than it announced");
    }
    --left_;
}

Verdict FalseAlarms::judge(const Estimate& e, std::size_t samples, double expected, const Sharpness& sharpness) const {
    const double scale = std::abs(expected);
    // Deviation beyond the bias; without noise, any such deviation is implausible
    const auto probability = [&](double difference) {
        const double excess = difference - sharpness.bias * scale;
        if (excess <= 0) {
            return 1.0;
        }
        return e.standardError > 0 ? studentTail(excess / e.standardError, samples - 1) : 0.0;
    };
    const double p = probability(std::abs(e.mean - expected));
    const bool sharp = probability(sharpness.sees * scale) < level_;
    std::ostringstream text;
    text.precision(7);
    text << "mean " << e.mean << " +- " << e.standardError << " by " << samples << " samples, expected " << expected
         << ", p = " << p << " at level " << level_;
    if (!sharp) {
        text << ": too noisy to see a difference of " << sharpness.sees * 100 << " %";
    }
    return {p >= level_ && sharp, text.str()};
}

Verdict FalseAlarms::mean(std::span<const double> samples, double expected, const Sharpness& sharpness) {
    use();
    return judge(estimate(samples), samples.size(), expected, sharpness);
}

// Over its standard deviation s, estimated from n others, the sample's distance from the known mean follows Student's
// distribution of n - 1 degrees of freedom.
Verdict FalseAlarms::draw(double sample, std::span<const double> others, double expected, const Sharpness& sharpness) {
    use();
    const double deviation = estimate(others).standardError * std::sqrt(static_cast<double>(others.size()));
    return judge({sample, deviation}, others.size(), expected, sharpness);
}

Verdict FalseAlarms::counts(std::span<const std::uint32_t> observed, std::span<const double> probabilities) {
    use();
    if (observed.size() != probabilities.size()) {
        throw std::logic_error("as many counts as probabilities, please");
    }
    constexpr double kFewest = 5;
    const double draws = std::accumulate(observed.begin(), observed.end(), 0.0);
    double statistic = 0;
    std::size_t cells = 0;
    double pooledCount = 0;
    double pooled = 0;
    std::size_t impossible = 0;
    const auto add = [&](double count, double expected) {
        statistic += (count - expected) * (count - expected) / expected;
        ++cells;
    };
    for (std::size_t i = 0; i < observed.size(); ++i) {
        const double expected = probabilities[i] * draws;
        if (probabilities[i] <= 0) {
            impossible += observed[i];
        } else if (expected >= kFewest) {
            add(observed[i], expected);
        } else {
            pooledCount += observed[i];
            pooled += expected;
        }
    }
    // A pool that also expects fewer than 5 is only tested for an excess: P(Poisson(m) >= k) is the complement of the
    // chi-square tail at 2 m with 2 k degrees of freedom
    double crowded = 1;
    if (pooled >= kFewest) {
        add(pooledCount, pooled);
    } else if (pooledCount > 0) {
        crowded = 1 - chiSquareTail(2 * pooled, 2 * static_cast<std::size_t>(pooledCount));
    }
    const double p = cells < 2 ? 0 : std::min(1.0, 2 * std::min(crowded, chiSquareTail(statistic, cells - 1)));
    std::ostringstream text;
    text << "chi^2 " << statistic << " of " << cells << " cells, " << draws << " draws, p = " << p << " at level "
         << level_ << ", " << impossible << " draws where there should be none";
    return {p >= level_ && impossible == 0, text.str()};
}

} // namespace hyalite::testing
