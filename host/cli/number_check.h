// Checks of numbers on the command line. CLI11's own checks accept NaN, because it compares false with every limit.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace hyalite::cli {

// A finite number, at least 0 or above 0.
inline CLI::Validator finiteNumber(bool zeroAllowed) {
    const std::string name = zeroAllowed ? "a number of at least 0" : "a number above 0";
    CLI::Validator check;
    check.operation([=](const std::string& text) {
        double value = 0;
        const bool good =
            CLI::detail::lexical_cast(text, value) && std::isfinite(value) && (zeroAllowed ? value >= 0 : value > 0);
        return good ? std::string() : "expected " + name + ", found '" + text + "'";
    });
    return check;
}

} // namespace hyalite::cli
