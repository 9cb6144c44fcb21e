// Times of repeated runs and their median.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hyalite::bench {

struct Run {
    double seconds = 0; // wall time
    double cores = 0;   // CPU time of all cores [s]: comparable on a busy machine too
};

// The middle value; for an even count, the mean of the two middle ones. Contract: not empty.
[[nodiscard]] inline double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// The median of a member, e.g. &Run::seconds.
[[nodiscard]] inline double median(const std::vector<Run>& runs, double Run::* member) {
    std::vector<double> values;
    for (const Run& run : runs) {
        values.push_back(run.*member);
    }
    return median(values);
}

// Measures wall and CPU time since its construction.
class RunClock {
public:
    RunClock();
    [[nodiscard]] Run elapsed() const;

private:
    Run start_;
};

// Time of one call.
template <class Body>
[[nodiscard]] Run timeOf(const Body& body) {
    const RunClock clock;
    body();
    return clock.elapsed();
}

// Times of `count` calls, after one uncounted call.
template <class Body>
[[nodiscard]] std::vector<Run> timesOf(int count, const Body& body) {
    body();
    std::vector<Run> runs;
    for (int run = 0; run < count; ++run) {
        runs.push_back(timeOf(body));
    }
    return runs;
}

} // namespace hyalite::bench
