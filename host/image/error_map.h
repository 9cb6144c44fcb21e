// A number for each pixel, and the false colours that show it.
#pragma once

#include "image/image.h"
#include "image/metrics.h"

#include <cstddef>
#include <vector>

namespace hyalite {

struct ErrorMap {
    int width = 0;
    int height = 0;
    std::vector<double> values; // width * height, row by row

    [[nodiscard]] double at(int x, int y) const {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

// The crop of the map in colours from black (0) through red and yellow to white (1, and above).
[[nodiscard]] Image falseColour(const ErrorMap& map, const Crop& crop);

} // namespace hyalite
