// What `hyalite parity` prints: a table and a verdict, or one JSON object.
#pragma once

#include "parity/parity.h"

#include <string>

namespace hyalite::cli {

// Stages by their first dispatch, then the picture; where something failed, its worst offenders.
[[nodiscard]] std::string parityTable(const parity::Result& result);

// One line: passed or not and, if not, where the two sides part first.
[[nodiscard]] std::string parityVerdict(const parity::Result& result);

[[nodiscard]] std::string parityJson(const parity::Result& result, const std::string& scene, const std::string& device);

} // namespace hyalite::cli
