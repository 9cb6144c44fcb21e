// Reads a whole input file into memory, with one clear error for each cause of failure.
#pragma once

#include "base/error.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace hyalite {

// The bytes of a regular file of 1 to `mostBytes` bytes. Throws Error(BadInput) at `where`; `kind` names what the
// file is for ("scene", "mesh").
[[nodiscard]] std::string readInputFile(const std::filesystem::path& path, std::size_t mostBytes,
                                        const std::string& kind, const SourceLocation& where);

} // namespace hyalite
