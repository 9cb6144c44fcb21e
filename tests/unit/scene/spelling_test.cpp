// Words in error messages, and numbers in text.
#include "base/numbers.h"
#include "base/spelling.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

using namespace hyalite;

TEST_CASE("the edit distance counts insertions, deletions, replacements and swaps of neighbours") {
    CHECK(editDistance("glass", "glass") == 0);
    CHECK(editDistance("", "abc") == 3);
    CHECK(editDistance("abc", "") == 3);
    CHECK(editDistance("glas", "glass") == 1);
    CHECK(editDistance("glaas", "glass") == 1);
    CHECK(editDistance("galss", "glass") == 1);
    CHECK(editDistance("kitten", "sitting") == 3); // k > s, e > i, + g
    CHECK(editDistance("ca", "abc") == 3);         // a swapped pair is not edited again
}

TEST_CASE("a hint names the nearest known word, or all words if none is near") {
    const std::array<std::string, 3> known{"diffuse", "mirror", "dielectric"};
    CHECK(spellingHint("miror", known) == "did you mean 'mirror'?");
    CHECK(spellingHint("dilectric", known) == "did you mean 'dielectric'?");
    CHECK(spellingHint("velvet", known) == "known: diffuse, mirror, dielectric");
    CHECK(spellingHint("x", {}).empty());
    CHECK(spellingHint(std::string(100000, 'x'), known) == "known: diffuse, mirror, dielectric");
    const std::array<std::string, 1> letter{"a"};
    CHECK(spellingHint("b", letter) == "known: a"); // every one-letter word is one edit from every other
}

TEST_CASE("text in a message stays on one line and is cut where it is long") {
    CHECK(inQuotes("glas") == "'glas'");
    CHECK(inQuotes("two\nlines\x1b[31m") == "'two?lines?[31m'");
    CHECK(inQuotes(std::string(61, 'x')) == "'" + std::string(60, 'x') + "...'");
}

TEST_CASE("numbers are read whole, in every form that YAML and mesh files use") {
    CHECK(parseNumber("-.25") == -0.25);
    CHECK(parseNumber("+1e3") == 1000.0);
    CHECK(parseNumber("7.") == 7.0);
    CHECK(parseNumber("1e-400") == 0.0);
    CHECK(parseNumber("1e400") == std::numeric_limits<double>::infinity());
    CHECK(parseNumber("-.inf") == -std::numeric_limits<double>::infinity());
    CHECK(std::isnan(parseNumber(".nan").value_or(0)));
    for (const auto* text : {"", "-", "+", "+-1", "1,5", "1.5x", "0x10", " 1", "1 ", "one"}) {
        INFO(text);
        CHECK_FALSE(parseNumber(text).has_value());
    }
    CHECK(parseWhole("-12") == -12);
    CHECK(parseWhole("+12") == 12);
    for (const auto* text : {"", "1.0", "1e3", "99999999999999999999", "0x10"}) {
        INFO(text);
        CHECK_FALSE(parseWhole(text).has_value());
    }
}

TEST_CASE("a number outside the range of double becomes infinity or zero by its size, however it is written") {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const std::string zeros(400, '0');
    CHECK(parseNumber("0." + zeros + "1") == 0.0); // 10^-401
    CHECK(parseNumber("-0." + zeros + "1") == 0.0);
    CHECK(parseNumber("0." + zeros + "1e-3") == 0.0);
    CHECK(parseNumber("0." + zeros + "1E+20") == 0.0); // 10^-381
    CHECK(parseNumber("+." + zeros + "1") == 0.0);
    CHECK(parseNumber("1" + zeros) == kInfinity); // 10^400
    CHECK(parseNumber("-1" + zeros + ".5") == -kInfinity);
    CHECK(parseNumber("1" + zeros + "e-20") == kInfinity); // 10^380
    CHECK(parseNumber("000" + zeros + "1e400") == kInfinity);
    CHECK(parseNumber("0." + zeros + "1e800") == kInfinity); // 10^399
    CHECK(parseNumber("1e99999999999999999999") == kInfinity);
    CHECK(parseNumber("1e-99999999999999999999") == 0.0);
    // What is long and yet of ordinary size
    CHECK(parseNumber("0." + zeros + "1e401") == 1.0);
    CHECK(parseNumber("1" + zeros + "e-400") == 1.0);
}

TEST_CASE("a number is printed with the fewest digits that read back") {
    CHECK(numberText(0.1) == "0.1");
    CHECK(numberText(65536) == "65536");
    CHECK(numberText(-1) == "-1");
}
