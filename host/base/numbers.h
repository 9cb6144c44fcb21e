// Numbers in text files, read the same way in every locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hyalite {

// The whole text as a decimal number; none when it is not one. "nan", "inf", YAML's ".nan" and ".inf", and what a
// double cannot hold come back as NaN or infinity, for the caller to refuse by name; what is too small for one is 0.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

// The whole text as a whole number; none when it is not one or does not fit.
[[nodiscard]] std::optional<std::int64_t> parseWhole(std::string_view text);

// Shortest text that reads back as the same number.
[[nodiscard]] std::string numberText(double value);

} // namespace hyalite
