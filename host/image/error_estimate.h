// What a render knows about the error of its picture; see docs/metrics.md.
#pragma once

#include <cstdint>
#include <optional>

namespace hyalite {

struct ErrorEstimate {
    // Root of the mean over pixels and channels of Var / (mean^2 + 0.01), where Var is the estimated variance of the
    // mean over the passes so far; none until both camera sequences have a pass, and none while the picture is black.
    std::optional<double> error = std::nullopt;
    // Pixels where light was sought and none was found yet. Each counts above with Var = 0.01: its error is unknown.
    std::uint32_t darkPixels = 0;
};

} // namespace hyalite
