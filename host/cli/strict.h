// Warnings on stderr, and the option --strict that makes errors of them.
#pragma once

#include "scene/model/warning.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace hyalite::cli {

void addStrictOption(CLI::App& app, bool& strict);

// Prints a line for each warning. With `strict` these are errors: throws Error(BadInput) if there is one.
void printWarnings(const std::vector<Warning>& warnings, bool strict);
void printWarnings(const std::vector<std::string>& warnings, bool strict);

// The warnings as texts.
[[nodiscard]] std::vector<std::string> textsOf(const std::vector<Warning>& warnings);

} // namespace hyalite::cli
