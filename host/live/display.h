// From radiance to what a screen shows.
#pragma once

#include "image/image.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hyalite::live {

struct Display {
    double exposure = 0;          // stops
    std::string toneMap = "clip"; // or "reinhard", "filmic"
    bool isQuantity = false;      // no light: scaled such that the 99th percentile is white
};

// Linear light in [0, 1], to be stored by the transfer function of sRGB.
[[nodiscard]] Image shownImage(const Image& image, const Display& display);

// Rows of red, green, blue, alpha bytes, sRGB.
[[nodiscard]] std::vector<std::uint8_t> shownBytes(const Image& image, const Display& display);

} // namespace hyalite::live
