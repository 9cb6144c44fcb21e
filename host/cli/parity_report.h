// What `hyalite parity` and `hyalite inspect` print.
#pragma once

#include "parity/parity.h"

#include <string>

namespace hyalite::cli {

// Stages by their first dispatch, then the picture; where something failed, its worst offenders.
[[nodiscard]] std::string parityTable(const parity::Result& result, const Scene& scene);

// Both sides of a path, vertex by vertex, the first difference marked.
[[nodiscard]] std::string pathTable(const parity::RecordedPath& path, const Scene& scene);

} // namespace hyalite::cli
