// FLIP, the difference that an observer sees when two pictures alternate on a screen; follows [Andersson20] (LDR-FLIP).
#pragma once

#include "image/error_map.h"
#include "image/metrics.h"

#include <numbers>

namespace hyalite {

// The paper's observer: 0.7 m from a screen 0.7 m wide with 3840 pixels across: about 67 pixels per degree.
inline constexpr double kPixelsPerDegree = 0.7 * (3840.0 / 0.7) * (std::numbers::pi / 180.0);

// The FLIP error of every pixel, in [0, 1]. FLIP is defined on what a screen shows: linear radiance is clipped to [0,
// 1] first, as writing a PNG file does (without rounding to 8 bits). Symmetric in its two pictures up to rounding.
[[nodiscard]] ErrorMap flipMap(const Image& image, const Image& reference, double pixelsPerDegree = kPixelsPerDegree);

// Mean of the map over the crop. The map must be of the whole pictures: FLIP looks at a pixel's neighbourhood, which a
// crop made beforehand would cut off.
[[nodiscard]] double mean(const ErrorMap& map, const Crop& crop);

} // namespace hyalite
