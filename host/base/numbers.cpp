// See numbers.h.
#include "base/numbers.h"

#include <algorithm>
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

// Whether a decimal number that no double can hold is too large for one, or else too small: the power of ten of its
// first digit that is not 0 says which. `text` is digits with at most one point, and an exponent perhaps.
bool isTooLarge(std::string_view text) {
    const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
    const std::string_view mantissa = text.substr(0, mark);
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    const std::size_t leading = mantissa.find_first_of("123456789");
    if (leading == std::string_view::npos) {
        return false;
    }
    const auto placed =
        static_cast<std::int64_t>(point) - static_cast<std::int64_t>(leading) - (leading < point ? 1 : 0);
    std::string_view digits = withoutPlus(text.substr(std::min(mark + 1, text.size())));
    std::int64_t exponent = 0;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec ==
        std::errc::result_out_of_range) { // no mantissa is long enough to make up for it
        return digits.front() != '-';
    }
    return placed + exponent >= 0;
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
        const double limit = isTooLarge(magnitude) ? std::numeric_limits<double>::infinity() : 0.0;
        return negative ? -limit : limit;
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
