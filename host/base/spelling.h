// Parts of error messages about an unknown word: the word, shown safely, and the known word that it resembles.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hyalite {

// 'text' in quotes on one line: control characters replaced, cut after 60 characters.
[[nodiscard]] std::string inQuotes(std::string_view text);

// ASCII letters made small.
[[nodiscard]] std::string lowerCase(std::string_view text);

// Letters to insert, delete, replace or swap with their neighbour to turn one word into the other
// (optimal string alignment).
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b);

// "did you mean 'glass'?" for a known word a few letters away, else "known: ..." with all of them, else nothing.
[[nodiscard]] std::string spellingHint(std::string_view word, std::span<const std::string> known);

} // namespace hyalite
