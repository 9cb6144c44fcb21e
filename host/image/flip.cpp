// FLIP [Andersson20]: colours are filtered as the eye does and compared in Hunt-adjusted L*a*b*, edges and points are
// detected and compared, and the feature difference amplifies the colour difference. All filters of the paper are sums
// of separable ones, so each is run as a horizontal and a vertical pass.
#include "image/flip.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace hyalite {
namespace {

using std::numbers::pi;

constexpr std::size_t kRowsPerTask = 16;

// ---- Colour spaces. D65 is (x, y) = (0.31271, 0.32902), sRGB's primaries are those of ITU-R BT.709.

glm::dvec3 xyzOfChromaticity(double x, double y) {
    return {x / y, 1.0, (1.0 - x - y) / y};
}

struct ColourSpaces {
    glm::dvec3 white = xyzOfChromaticity(0.31271, 0.32902);
    glm::dmat3 xyzFromRgb = makeXyzFromRgb();
    glm::dmat3 rgbFromXyz = glm::inverse(xyzFromRgb);

private:
    // Columns are the primaries, scaled so that red, green and blue together are white.
    [[nodiscard]] glm::dmat3 makeXyzFromRgb() const {
        const glm::dmat3 primaries(xyzOfChromaticity(0.64, 0.33), xyzOfChromaticity(0.30, 0.60),
                                   xyzOfChromaticity(0.15, 0.06));
        const glm::dvec3 scale = glm::inverse(primaries) * white;
        return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
    }
};

// The linear opponent space YyCxCz in which the eye's contrast sensitivity is modelled.
glm::dvec3 opponentFromRgb(const ColourSpaces& spaces, const glm::dvec3& rgb) {
    const glm::dvec3 n = spaces.xyzFromRgb * rgb / spaces.white;
    return {116.0 * n.y - 16.0, 500.0 * (n.x - n.y), 200.0 * (n.y - n.z)};
}

glm::dvec3 rgbFromOpponent(const ColourSpaces& spaces, const glm::dvec3& c) {
    const double y = (c.x + 16.0) / 116.0;
    return spaces.rgbFromXyz * (glm::dvec3(y + c.y / 500.0, y, y - c.z / 200.0) * spaces.white);
}

// CIE L*a*b*, then the Hunt effect: dark colours look less colourful.
glm::dvec3 huntLabFromRgb(const ColourSpaces& spaces, const glm::dvec3& rgb) {
    constexpr double kDelta = 6.0 / 29.0;
    const auto f = [](double t) {
        return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
    };
    const glm::dvec3 n = spaces.xyzFromRgb * rgb / spaces.white;
    const double L = 116.0 * f(n.y) - 16.0;
    const double a = 500.0 * (f(n.x) - f(n.y));
    const double b = 200.0 * (f(n.y) - f(n.z));
    return {L, 0.01 * L * a, 0.01 * L * b};
}

double hyab(const glm::dvec3& p, const glm::dvec3& q) {
    return std::abs(p.x - q.x) + std::hypot(p.y - q.y, p.z - q.z);
}

// ---- Filters. A kernel has 2 * radius + 1 weights; beyond the border the nearest pixel is repeated.

using Kernel = std::vector<double>;

template <typename Weight>
Kernel makeKernel(int radius, const Weight& weight) {
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i) {
        kernel.push_back(weight(static_cast<double>(i)));
    }
    return kernel;
}

// Scales the positive weights to a sum of 1 and the negative ones to a sum of -1.
void normalize(Kernel& kernel) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double weight : kernel) {
        (weight > 0.0 ? positive : negative) += std::abs(weight);
    }
    for (double& weight : kernel) {
        weight /= weight > 0.0 ? positive : negative > 0.0 ? negative : 1.0;
    }
}

struct Plane {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<double> values;

    Plane(std::size_t w, std::size_t h) : width(w), height(h), values(w * h) {}
    [[nodiscard]] std::span<double> row(std::size_t y) { return std::span(values).subspan(y * width, width); }
    [[nodiscard]] std::span<const double> row(std::size_t y) const {
        return std::span(values).subspan(y * width, width);
    }
};

void addScaled(std::span<double> sum, double weight, std::span<const double> values) {
    for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += weight * values[i];
    }
}

Plane filterRows(const Plane& plane, const Kernel& kernel) {
    Plane result(plane.width, plane.height);
    const std::size_t radius = kernel.size() / 2;
    parallelFor(plane.height, kRowsPerTask, [&](std::size_t begin, std::size_t end) {
        std::vector<double> padded(plane.width + 2 * radius);
        for (std::size_t y = begin; y < end; ++y) {
            const std::span<const double> row = plane.row(y);
            std::fill_n(padded.begin(), radius, row.front());
            std::ranges::copy(row, padded.begin() + static_cast<std::ptrdiff_t>(radius));
            std::fill_n(padded.rbegin(), radius, row.back());
            for (std::size_t k = 0; k < kernel.size(); ++k) {
                addScaled(result.row(y), kernel[k], std::span<const double>(padded).subspan(k, plane.width));
            }
        }
    });
    return result;
}

Plane filterColumns(const Plane& plane, const Kernel& kernel) {
    Plane result(plane.width, plane.height);
    const std::size_t radius = kernel.size() / 2;
    parallelFor(plane.height, kRowsPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
            for (std::size_t k = 0; k < kernel.size(); ++k) {
                const std::size_t source = std::clamp(y + k, radius, plane.height - 1 + radius) - radius;
                addScaled(result.row(y), kernel[k], plane.row(source));
            }
        }
    });
    return result;
}

Plane filter(const Plane& plane, const Kernel& alongX, const Kernel& alongY) {
    return filterColumns(filterRows(plane, alongX), alongY);
}

// ---- Colour pipeline (section 4.1 of the paper).

// A contrast sensitivity function in the image: a sum of Gaussians a * sqrt(pi / b) * exp(-pi^2 d^2 / b), d in degrees.
struct Gaussian {
    double a;
    double b; // [degree^2]
};
using Sensitivity = std::array<Gaussian, 2>;

constexpr Sensitivity kAchromatic{{{1.0, 0.0047}, {0.0, 1e-5}}};
constexpr Sensitivity kRedGreen{{{1.0, 0.0053}, {0.0, 1e-5}}};
constexpr Sensitivity kBlueYellow{{{34.1, 0.04}, {13.5, 0.025}}};
constexpr double kWidestB = 0.04;

// Filters with the sensitivity, scaled to a sum of 1 over the filter's square.
Plane filterSensitivity(const Plane& plane, const Sensitivity& sensitivity, double pixelsPerDegree) {
    // Three standard deviations of the widest Gaussian: exp(-pi^2 d^2 / b) has sigma = sqrt(b / (2 pi^2)).
    const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(kWidestB / (2.0 * pi * pi)) * pixelsPerDegree));
    Plane result(plane.width, plane.height);
    double total = 0.0;
    for (const Gaussian& gaussian : sensitivity) {
        if (gaussian.a == 0.0) {
            continue;
        }
        Kernel kernel = makeKernel(radius, [&](double i) {
            return std::exp(-pi * pi * i * i / (gaussian.b * pixelsPerDegree * pixelsPerDegree));
        });
        double sum = 0.0;
        for (const double weight : kernel) {
            sum += weight;
        }
        const double share =
            gaussian.a * std::sqrt(pi / gaussian.b) * sum * sum; // of this Gaussian in the sum over the square
        normalize(kernel);
        addScaled(result.values, share, filter(plane, kernel, kernel).values);
        total += share;
    }
    for (double& value : result.values) {
        value /= total;
    }
    return result;
}

// HyAB distances are raised to 0.7 and spread over [0, 1]: the lower 40 % of the range, where most differences lie,
// gets 95 % of it. The range ends at the distance between green and blue, the largest of sRGB.
class ErrorScale {
public:
    explicit ErrorScale(const ColourSpaces& spaces)
        : largest_(std::pow(hyab(huntLabFromRgb(spaces, {0, 1, 0}), huntLabFromRgb(spaces, {0, 0, 1})), kExponent)) {}

    [[nodiscard]] double operator()(double distance) const {
        constexpr double kKnee = 0.4;
        constexpr double kKneeError = 0.95;
        const double error = std::pow(distance, kExponent) / largest_;
        return error < kKnee ? error * (kKneeError / kKnee)
                             : kKneeError + (error - kKnee) / (1.0 - kKnee) * (1.0 - kKneeError);
    }

private:
    static constexpr double kExponent = 0.7;
    double largest_;
};

// ---- Feature pipeline (section 4.2): edges and points of the normalised luminance, as magnitudes.

struct Features {
    Plane edge;
    Plane point;
};

Plane magnitude(const Plane& luminance, const Kernel& derivative, const Kernel& smoothing) {
    Plane result = filter(luminance, derivative, smoothing);
    const Plane along = filter(luminance, smoothing, derivative);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        result.values[i] = std::hypot(result.values[i], along.values[i]);
    }
    return result;
}

Features detectFeatures(const Plane& luminance, double pixelsPerDegree) {
    constexpr double kFilterWidth = 0.082; // [degree] peak to trough of the eye's edge detector
    const double sigma = 0.5 * kFilterWidth * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    const auto gauss = [&](double x) { return std::exp(-x * x / (2.0 * sigma * sigma)); };
    Kernel smoothing = makeKernel(radius, gauss);
    Kernel firstDerivative = makeKernel(radius, [&](double x) { return -x * gauss(x); });
    Kernel secondDerivative = makeKernel(radius, [&](double x) { return (x * x / (sigma * sigma) - 1.0) * gauss(x); });
    for (Kernel* kernel : {&smoothing, &firstDerivative, &secondDerivative}) {
        normalize(*kernel);
    }
    return {magnitude(luminance, firstDerivative, smoothing), magnitude(luminance, secondDerivative, smoothing)};
}

// ---- Both together.

struct Appearance {
    std::vector<glm::dvec3> huntLab; // of the filtered picture
    Features features;
};

Appearance perceive(const Image& image, const ColourSpaces& spaces, double pixelsPerDegree) {
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    std::array<Plane, 3> opponent{Plane(width, height), Plane(width, height), Plane(width, height)};
    Plane luminance(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::dvec3 c = opponentFromRgb(spaces, glm::clamp(glm::dvec3(image.pixels[i]), 0.0, 1.0));
        opponent[0].values[i] = c.x;
        opponent[1].values[i] = c.y;
        opponent[2].values[i] = c.z;
        luminance.values[i] = (c.x + 16.0) / 116.0;
    }
    opponent[0] = filterSensitivity(opponent[0], kAchromatic, pixelsPerDegree);
    opponent[1] = filterSensitivity(opponent[1], kRedGreen, pixelsPerDegree);
    opponent[2] = filterSensitivity(opponent[2], kBlueYellow, pixelsPerDegree);

    std::vector<glm::dvec3> huntLab(image.pixels.size());
    parallelFor(huntLab.size(), kRowsPerTask * width, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec3 c(opponent[0].values[i], opponent[1].values[i], opponent[2].values[i]);
            huntLab[i] = huntLabFromRgb(spaces, glm::clamp(rgbFromOpponent(spaces, c), 0.0, 1.0));
        }
    });
    return {std::move(huntLab), detectFeatures(luminance, pixelsPerDegree)};
}

} // namespace

ErrorMap flipMap(const Image& image, const Image& reference, double pixelsPerDegree) {
    requireComparable(image, reference, wholeOf(image));
    const ColourSpaces spaces;
    const ErrorScale colourError(spaces);
    const Appearance a = perceive(image, spaces, pixelsPerDegree);
    const Appearance r = perceive(reference, spaces, pixelsPerDegree);

    ErrorMap map{image.width, image.height, std::vector<double>(image.pixels.size())};
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        const double colour = colourError(hyab(a.huntLab[i], r.huntLab[i]));
        const double edge = std::abs(a.features.edge.values[i] - r.features.edge.values[i]);
        const double point = std::abs(a.features.point.values[i] - r.features.point.values[i]);
        const double feature = std::sqrt(std::max(edge, point) / std::numbers::sqrt2);
        map.values[i] = std::pow(colour, 1.0 - feature);
    }
    return map;
}

double mean(const ErrorMap& map, const Crop& crop) {
    double sum = 0.0;
    for (int y = crop.y0; y < crop.y0 + crop.height; ++y) {
        for (int x = crop.x0; x < crop.x0 + crop.width; ++x) {
            sum += map.at(x, y);
        }
    }
    return sum / (static_cast<double>(crop.width) * static_cast<double>(crop.height));
}

} // namespace hyalite
