// See numbers.h.
#include "base/numbers.h"

#include <array>
#include <charconv>
#include <limits>
#include <system_error>

namespace hyalite {
namespace {

// std::from_chars knows no plus sign.
std::string_view withoutPlus(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
        text.remove_prefix(1);
    }
    return text;
}

} // namespace

std::optional<double> parseNumber(std::string_view text) {
    text = withoutPlus(text);
    const bool negative = !text.empty() && text[0] == '-';
    const std::string_view magnitude = text.substr(negative ? 1 : 0);
    for (const std::string_view name : {".inf", ".Inf", ".INF"}) {
        if (magnitude == name) {
            return std::numeric_limits<double>::infinity() * (negative ? -1 : 1);
        }
    }
    for (const std::string_view name : {".nan", ".NaN", ".NAN"}) {
        if (text == name) {
            return std::numeric_limits<double>::quiet_NaN();
        }
    }

    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument) {
        return std::nullopt;
    }
    if (error == std::errc::result_out_of_range) {
        const bool tiny = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
        return tiny ? 0.0 : std::numeric_limits<double>::infinity() * (negative ? -1 : 1);
    }
    return value;
}

std::optional<std::int64_t> parseWhole(std::string_view text) {
    text = withoutPlus(text);
    std::int64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (stop != end || error != std::errc{}) {
        return std::nullopt;
    }
    return value;
}

std::string numberText(double value) {
    std::array<char, 32> digits{};
    const auto [stop, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc{} ? std::string(digits.data(), stop) : std::to_string(value);
}

} // namespace hyalite
