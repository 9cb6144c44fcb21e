// Converts radiance to what a screen shows.
#pragma once

#include "image/image.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hyalite::live {

struct Display {
    double exposure = 0;          // stops
    std::string toneMap = "clip"; // or "reinhard", "filmic"
    bool isQuantity = false;      // not light: scaled so that the 99th percentile is white, and not tone-mapped
};

// Linear values in [0, 1], before the transfer function of sRGB.
[[nodiscard]] Image shownImage(const Image& image, const Display& display);

// The same as sRGB bytes: rows of red, green, blue, alpha.
[[nodiscard]] std::vector<std::uint8_t> shownBytes(const Image& image, const Display& display);

} // namespace hyalite::live
