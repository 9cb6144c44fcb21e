// Describes the machine for a report.
#pragma once

#include "gpu/context.h"

#include <string>
#include <utility>
#include <vector>

namespace hyalite::cli {

// Names and values: device, driver (with its Mesa and LLVM), vector width, threads, processor and its features.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> describeMachine(const gpu::Context& context);

} // namespace hyalite::cli
