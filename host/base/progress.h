// A progress bar on a terminal: how far, how fast, how long still. Silent anywhere else.
#pragma once

#include <chrono>
#include <string>

namespace hyalite {

class ProgressBar {
public:
    // Draws on stderr if that is a terminal and `enabled`.
    explicit ProgressBar(bool enabled);
    ~ProgressBar(); // wipes the bar
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    // `done` of `total` steps (total >= 1) after `seconds`; redraws at most ten times a second. A time limit [s] that
    // comes before the last step counts instead of it; 0: none.
    void update(std::size_t done, std::size_t total, double seconds, double timeLimit = 0);

private:
    bool shown_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point next_{};
};

// The bar's text, e.g. "[#####     ]  50 %  32/64 passes  0:12 left".
[[nodiscard]] std::string progressLine(std::size_t done, std::size_t total, double seconds, double timeLimit);

} // namespace hyalite
