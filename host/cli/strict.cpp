#include "cli/strict.h"

#include "scene/checks/light_check.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <iterator>

namespace hyalite::cli {

void addStrictOption(CLI::App& app, bool& strict) {
    app.add_flag("--strict", strict, "make every warning an error (exit code 3)");
}

std::vector<Warning> warningsOf(const Scene& scene) {
    std::vector<Warning> warnings = scene.warnings;
    std::ranges::move(checks::lightWarnings(scene), std::back_inserter(warnings));
    return warnings;
}

void printWarnings(const std::vector<Warning>& warnings, bool strict) {
    printWarnings(textsOf(warnings), strict);
}

void printWarnings(const std::vector<std::string>& warnings, bool strict) {
    for (std::size_t i = 0; i < warnings.size(); ++i) {
        if (strict && i + 1 == warnings.size()) {
            throw Error(ExitCode::BadInput, warnings[i]); // the program prints the error that ends it
        }
        std::cerr << "hyalite: " << (strict ? "" : "warning: ") << warnings[i] << '\n';
    }
}

std::vector<std::string> textsOf(const std::vector<Warning>& warnings) {
    std::vector<std::string> texts;
    for (const Warning& warning : warnings) {
        texts.push_back(warning.text());
    }
    return texts;
}

} // namespace hyalite::cli
