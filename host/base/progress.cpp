#include "base/progress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace hyalite {

namespace {

constexpr auto kRedrawInterval = std::chrono::milliseconds(100);
constexpr std::size_t kBarWidth = 30;

// Back to the line's start, and clear it.
constexpr const char* kWipe = "\r\x1b[K";

std::string minutes(double seconds) {
    const auto whole = static_cast<long>(std::ceil(std::max(0.0, seconds)));
    const std::string rest = std::to_string(whole % 60);
    return std::to_string(whole / 60) + (rest.size() < 2 ? ":0" : ":") + rest;
}

} // namespace

std::string progressLine(const ProgressState& state) {
    const auto& [done, total, seconds, timeLimit, error, before] = state;
    double share = static_cast<double>(done) / static_cast<double>(total);
    double left = done > before ? seconds / static_cast<double>(done - before) * static_cast<double>(total - done) : 0;
    if (timeLimit > 0 && timeLimit - seconds < left) {
        left = timeLimit - seconds;
        share = std::min(1.0, seconds / timeLimit);
    }
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(kBarWidth));
    const std::string percent = std::to_string(static_cast<int>(100 * share));
    std::string line = '[' + std::string(filled, '#') + std::string(kBarWidth - filled, ' ') + "] ";
    line += std::string(3 - std::min<std::size_t>(3, percent.size()), ' ') + percent + " %  ";
    line += std::to_string(done) + '/' + std::to_string(total) + " passes  ";
    line += done == 0 ? "starting" : minutes(left) + " left";
    if (error) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "  error %.2g", *error);
        line += text.data();
    }
    return line;
}

ProgressBar::ProgressBar(bool enabled) : shown_(enabled && isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    if (drawn_) {
        std::fputs(kWipe, stderr);
    }
}

void ProgressBar::update(const ProgressState& state) {
    const auto now = std::chrono::steady_clock::now();
    if (!shown_ || now < next_) {
        return;
    }
    next_ = now + kRedrawInterval;
    drawn_ = true;
    std::fputs((kWipe + progressLine(state)).c_str(), stderr);
    std::fflush(stderr);
}

} // namespace hyalite
