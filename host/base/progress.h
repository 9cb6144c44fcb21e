// A progress bar on a terminal: passes done, time left, estimated error. Silent anywhere else.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace hyalite {

struct ProgressState {
    std::size_t done = 0;
    std::size_t total = 1;            // >= 1
    double seconds = 0;               // since the first step began
    double timeLimit = 0;             // [s]; counts in place of the last step where it comes first; 0: none
    std::optional<double> error = {}; // shown if known
    std::size_t before = 0;           // steps done before the clock started
};

class ProgressBar {
public:
    // Draws on stderr if that is a terminal and `enabled`.
    explicit ProgressBar(bool enabled);
    ~ProgressBar(); // wipes the bar
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    // Redraws at most ten times a second.
    void update(const ProgressState& state);

private:
    bool shown_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point next_{};
};

// The bar's text, e.g. "[#####     ]  50 %  32/64 passes  0:12 left  error 0.041".
[[nodiscard]] std::string progressLine(const ProgressState& state);

} // namespace hyalite
