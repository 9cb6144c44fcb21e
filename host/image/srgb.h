// The piecewise transfer function of sRGB (IEC 61966-2-1): linear light to stored value and back.
#pragma once

#include <cmath>

namespace hyalite {

// Both map [0, 1] to [0, 1]; linear radiance above 1 must be clipped before.
[[nodiscard]] inline double srgbFromLinear(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

[[nodiscard]] inline double linearFromSrgb(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

} // namespace hyalite
