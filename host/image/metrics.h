// How far a picture is from its reference, in numbers on linear radiance. Definitions: docs/metrics.md.
#pragma once

#include "image/image.h"

namespace hyalite {

// A rectangle of pixels; x0, y0 is its upper left corner.
struct Crop {
    int x0 = 0;
    int y0 = 0;
    int width = 0;
    int height = 0;
};

[[nodiscard]] inline Crop wholeOf(const Image& image) {
    return {0, 0, image.width, image.height};
}

// Throws Error(WrongUsage) unless both pictures have one size and the crop holds a pixel and lies inside, and
// Error(BadInput) where a value is NaN or infinite, for which no metric is defined. All functions below begin with it.
void requireComparable(const Image& image, const Image& reference, const Crop& crop);

// Square root of the mean over pixels and channels of (a - r)^2, in the unit of radiance.
[[nodiscard]] double rmse(const Image& image, const Image& reference, const Crop& crop);

// Mean over pixels and channels of (a - r)^2 / (r^2 + 0.01).
[[nodiscard]] double relMse(const Image& image, const Image& reference, const Crop& crop);

struct LargestDifference {
    double value = 0.0; // max over pixels and channels of |a - r|
    int x = 0;          // the first pixel that has it, in reading order
    int y = 0;
};
[[nodiscard]] LargestDifference largestDifference(const Image& image, const Image& reference, const Crop& crop);

// Share in [0, 1] of the pixels whose every channel has |a - r| <= tolerance * |r|; a black reference requires black.
[[nodiscard]] double shareWithin(const Image& image, const Image& reference, double tolerance, const Crop& crop);

} // namespace hyalite
