#include "live/server/display.h"

#include "image/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hyalite::live {

namespace {

using glm::vec3;

vec3 reinhard(const vec3& c) {
    const float luminance = 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b;
    return c / (1 + luminance);
}

// A curve with a toe and a shoulder, like film's.
vec3 filmic(const vec3& c) {
    return c * (2.51F * c + 0.03F) / (c * (2.43F * c + 0.59F) + 0.14F);
}

float percentile99(const Image& image) {
    std::vector<float> values;
    values.reserve(image.pixels.size());
    for (const vec3& pixel : image.pixels) {
        values.push_back(std::max({pixel.r, pixel.g, pixel.b}));
    }
    const std::size_t at = values.size() * 99 / 100;
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(at));
    return values.empty() || values[at] <= 0 ? 1.0F : values[at];
}

// The transfer function at 4097 points, rounded: within half a byte of the exact function between them too.
std::array<std::uint8_t, 4097> makeTable() {
    std::array<std::uint8_t, 4097> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        // Evenly spaced in the square root, so that dark values have enough points
        const double root = static_cast<double>(i) / 4096;
        table.at(i) = static_cast<std::uint8_t>(std::lround(255 * srgbFromLinear(root * root)));
    }
    return table;
}

} // namespace

Image shownImage(const Image& image, const Display& display) {
    const float scale =
        static_cast<float>(std::exp2(display.exposure)) / (display.isQuantity ? percentile99(image) : 1);
    Image shown = image;
    for (vec3& pixel : shown.pixels) {
        vec3 c = pixel * scale;
        for (int i = 0; i < 3; ++i) {
            c[i] = c[i] > 0 ? std::min(c[i], 1e6F) : 0.0F; // NaN becomes black
        }
        if (!display.isQuantity && display.toneMap == "reinhard") {
            c = reinhard(c);
        } else if (!display.isQuantity && display.toneMap == "filmic") {
            c = filmic(c);
        }
        pixel = glm::clamp(c, 0.0F, 1.0F);
    }
    return shown;
}

std::vector<std::uint8_t> shownBytes(const Image& image, const Display& display) {
    static const std::array<std::uint8_t, 4097> table = makeTable();
    const Image shown = shownImage(image, display);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 * shown.pixels.size());
    for (const vec3& pixel : shown.pixels) {
        for (int i = 0; i < 3; ++i) {
            // NOLINTNEXTLINE(bugprone-incorrect-roundings): never negative
            bytes.push_back(table.at(static_cast<std::size_t>(std::sqrt(pixel[i]) * 4096 + 0.5F)));
        }
        bytes.push_back(255);
    }
    return bytes;
}

} // namespace hyalite::live
