// How far a picture is from its reference: sums in double, in reading order, so that a result is the same every time.
#include "image/metrics.h"

#include "base/error.h"
#include "image/image_io.h"

#include <cmath>
#include <cstdint>
#include <string>

namespace hyalite {
namespace {

std::string sizeText(const Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

// Calls visit(x, y, a, r) for every pixel of the crop.
template <typename Visit>
void forEachPixel(const Image& image, const Image& reference, const Crop& crop, const Visit& visit) {
    requireComparable(image, reference, crop);
    for (int y = crop.y0; y < crop.y0 + crop.height; ++y) {
        for (int x = crop.x0; x < crop.x0 + crop.width; ++x) {
            visit(x, y, glm::dvec3(image.at(x, y)), glm::dvec3(reference.at(x, y)));
        }
    }
}

double pixelCount(const Crop& crop) {
    return static_cast<double>(crop.width) * static_cast<double>(crop.height);
}

} // namespace

void requireComparable(const Image& image, const Image& reference, const Crop& crop) {
    if (image.width != reference.width || image.height != reference.height) {
        throw Error(ExitCode::WrongUsage,
                    "the pictures differ in size: " + sizeText(image) + " and " + sizeText(reference));
    }
    const bool inside = crop.x0 >= 0 && crop.y0 >= 0 && crop.width >= 1 && crop.height >= 1 &&
                        std::int64_t{crop.x0} + crop.width <= image.width &&
                        std::int64_t{crop.y0} + crop.height <= image.height;
    if (!inside) {
        throw Error(ExitCode::WrongUsage, "the crop does not lie inside the picture of " + sizeText(image),
                    "a crop is X,Y,WIDTH,HEIGHT in pixels");
    }
    const std::size_t notFinite = countNotFinite(image) + countNotFinite(reference);
    if (notFinite > 0) {
        throw Error(ExitCode::BadInput, std::to_string(notFinite) + " pixels are NaN or infinite");
    }
}

double rmse(const Image& image, const Image& reference, const Crop& crop) {
    double sum = 0.0;
    forEachPixel(image, reference, crop, [&](int /*x*/, int /*y*/, const glm::dvec3& a, const glm::dvec3& r) {
        sum += glm::dot(a - r, a - r);
    });
    return std::sqrt(sum / (3.0 * pixelCount(crop)));
}

double relMse(const Image& image, const Image& reference, const Crop& crop) {
    constexpr double kDarkFloor = 0.01; // keeps black pixels from deciding alone
    double sum = 0.0;
    forEachPixel(image, reference, crop, [&](int /*x*/, int /*y*/, const glm::dvec3& a, const glm::dvec3& r) {
        const glm::dvec3 relative = (a - r) * (a - r) / (r * r + kDarkFloor);
        sum += relative.x + relative.y + relative.z;
    });
    return sum / (3.0 * pixelCount(crop));
}

LargestDifference largestDifference(const Image& image, const Image& reference, const Crop& crop) {
    LargestDifference largest{0.0, crop.x0, crop.y0};
    forEachPixel(image, reference, crop, [&](int x, int y, const glm::dvec3& a, const glm::dvec3& r) {
        const glm::dvec3 difference = glm::abs(a - r);
        const double value = std::fmax(difference.x, std::fmax(difference.y, difference.z));
        if (value > largest.value) {
            largest = {value, x, y};
        }
    });
    return largest;
}

double shareWithin(const Image& image, const Image& reference, double tolerance, const Crop& crop) {
    double within = 0.0;
    forEachPixel(image, reference, crop, [&](int /*x*/, int /*y*/, const glm::dvec3& a, const glm::dvec3& r) {
        if (glm::all(glm::lessThanEqual(glm::abs(a - r), tolerance * glm::abs(r)))) {
            within += 1.0;
        }
    });
    return within / pixelCount(crop);
}

} // namespace hyalite
