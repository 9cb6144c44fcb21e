// Output of the results: as JSON, and as one self-contained HTML page.
#pragma once

#include "parity/parity.h"

#include <string>
#include <utility>
#include <vector>

namespace hyalite::parity {

// Scene, command and machine of a comparison.
struct Circumstances {
    std::string scene; // file
    std::string command;
    std::vector<std::pair<std::string, std::string>> machine; // name and value
    std::vector<std::string> warnings = {};                   // about the scene
};

// One line: passed or failed and, if failed, where the two sides first differ.
[[nodiscard]] std::string verdict(const Result& result);

// One JSON object.
[[nodiscard]] std::string toJson(const Result& result, const Circumstances& circumstances);

// The same as an HTML page, with pictures and the path of every pixel.
[[nodiscard]] std::string toHtml(const Result& result, const Scene& scene, const Circumstances& circumstances);

} // namespace hyalite::parity
