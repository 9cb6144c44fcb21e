// What was found, for others to read: as JSON, and as one HTML page that needs nothing else.
#pragma once

#include "parity/parity.h"

#include <string>
#include <utility>
#include <vector>

namespace hyalite::parity {

// Where and of what a comparison was made.
struct Circumstances {
    std::string scene; // file
    std::string command;
    std::vector<std::pair<std::string, std::string>> machine; // name and value
};

// One line: passed or not and, if not, where the two sides part first.
[[nodiscard]] std::string verdict(const Result& result);

// One JSON object.
[[nodiscard]] std::string toJson(const Result& result, const Circumstances& circumstances);

// A page that shows the same, with pictures, and the path of every pixel.
[[nodiscard]] std::string toHtml(const Result& result, const Scene& scene, const Circumstances& circumstances);

} // namespace hyalite::parity
