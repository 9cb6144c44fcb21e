// Warnings on stderr, and the option --strict that makes errors of them.
#pragma once

#include "scene/model/scene.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace hyalite::cli {

void addStrictOption(CLI::App& app, bool& strict);

// All warnings about the scene, which has its settings.
[[nodiscard]] std::vector<Warning> warningsOf(const Scene& scene);

// Prints a line for each warning. With `strict` these are errors: throws Error(BadInput) if there is one.
void printWarnings(const std::vector<Warning>& warnings, bool strict);
void printWarnings(const std::vector<std::string>& warnings, bool strict);

// The warnings as texts.
[[nodiscard]] std::vector<std::string> textsOf(const std::vector<Warning>& warnings);

} // namespace hyalite::cli
