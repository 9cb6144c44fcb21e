// The text that `hyalite parity` and `hyalite inspect` print.
#pragma once

#include "parity/parity.h"

#include <string>

namespace hyalite::cli {

// Stages in order of their first dispatch with the worst offenders of failed ones, then paths and the picture.
[[nodiscard]] std::string parityTable(const parity::Result& result, const Scene& scene);

// Both sides of a path, vertex by vertex, with the first difference marked.
[[nodiscard]] std::string pathTable(const parity::RecordedPath& path, const Scene& scene);

} // namespace hyalite::cli
