// FLIP against hand-derived values on flat pictures and against the paper's formulas written out on a small one.
#include "image/flip.h"

#include "unit/image/temporary_folder.h"

#include <algorithm>
#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace hyalite;
using Catch::Approx;
using std::numbers::pi;

namespace {

Image flat(const glm::vec3& colour, int width = 24, int height = 20) {
    Image image(width, height);
    std::ranges::fill(image.pixels, colour);
    return image;
}

double meanFlip(const Image& image, const Image& reference) {
    return mean(flipMap(image, reference), wholeOf(reference));
}

// White left of column `edge`, black from there on.
Image halves(int edge, int width = 96, int height = 16) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < edge; ++x) {
            image.at(x, y) = {1, 1, 1};
        }
    }
    return image;
}

// CIE lightness of a grey of luminance Y > (6/29)^3.
double lightness(double Y) {
    return 116.0 * std::cbrt(Y) - 16.0;
}

// The largest HyAB distance of sRGB, green to blue. CIE L*a*b* of the primaries under D65, from any colour table:
//   green (87.735, -86.183, 83.179), blue (32.297, 79.188, -107.860). The Hunt effect scales a and b by L / 100:
//   green (-75.613, 72.977), blue (25.575, -34.836). |dL| + |d(a, b)| = 55.438 + |(101.188, 107.813)| = 203.298.
// Tables differ in the fifth digit, as their digits of D65 do: hence tolerances of 1e-4.
constexpr double kLargestHyab = 203.298;

// ---- The paper's formulas, written out in two dimensions without regard for speed.

using Map = std::vector<double>;

struct Direct {
    int width;
    int height;

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }

    // Correlation with weight(i, j) over |i|, |j| <= radius; the border pixels go on outside.
    template <typename Weight>
    [[nodiscard]] Map filter(const Map& map, int radius, const Weight& weight) const {
        Map result(map.size());
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                double sum = 0.0;
                for (int j = -radius; j <= radius; ++j) {
                    for (int i = -radius; i <= radius; ++i) {
                        const int u = std::clamp(x + i, 0, width - 1);
                        const int v = std::clamp(y + j, 0, height - 1);
                        sum += weight(i, j) * map[index(u, v)];
                    }
                }
                result[index(x, y)] = sum;
            }
        }
        return result;
    }

    // The same with the positive weights scaled to a sum of 1 and the negative to -1.
    template <typename Weight>
    [[nodiscard]] Map filterNormalized(const Map& map, int radius, const Weight& weight) const {
        double positive = 0.0;
        double negative = 0.0;
        for (int j = -radius; j <= radius; ++j) {
            for (int i = -radius; i <= radius; ++i) {
                positive += std::max(weight(i, j), 0.0);
                negative += std::max(-weight(i, j), 0.0);
            }
        }
        return filter(map, radius, [&](int i, int j) {
            const double w = weight(i, j);
            return w > 0.0 ? w / positive : w < 0.0 ? w / negative : 0.0;
        });
    }

    [[nodiscard]] std::array<Map, 2> features(const Map& luminance) const {
        const double s = 0.5 * 0.082 * kPixelsPerDegree;
        const int radius = static_cast<int>(std::ceil(3.0 * s));
        const auto gauss = [&](int i, int j) { return std::exp(-(i * i + j * j) / (2.0 * s * s)); };
        const auto edge = [&](int i, int j) { return -i * gauss(i, j); };
        const auto point = [&](int i, int j) { return (i * i / (s * s) - 1.0) * gauss(i, j); };
        const auto norm = [&](const auto& kernel) {
            const Map dx = filterNormalized(luminance, radius, kernel);
            const Map dy = filterNormalized(luminance, radius, [&](int i, int j) { return kernel(j, i); });
            Map length(dx.size());
            std::ranges::transform(dx, dy, length.begin(), [](double a, double b) { return std::sqrt(a * a + b * b); });
            return length;
        };
        return {norm(edge), norm(point)};
    }

    // Hunt-adjusted L*a*b* after the contrast sensitivity filters, and the luminance before them.
    [[nodiscard]] std::array<Map, 4> perceive(const Image& image) const;
};

// Rounded forms of the sRGB matrix (IEC 61966-2-1 gives four decimals), hence the tolerance of the comparison.
const glm::dmat3 kXyzFromRgb = glm::transpose(glm::dmat3(0.4124, 0.3576, 0.1805, //
                                                         0.2126, 0.7152, 0.0722, //
                                                         0.0193, 0.1192, 0.9505));

std::array<Map, 4> Direct::perceive(const Image& image) const {
    const glm::dvec3 white = kXyzFromRgb * glm::dvec3(1.0);
    std::array<Map, 3> c;
    Map luminance;
    for (const glm::vec3& pixel : image.pixels) {
        const glm::dvec3 n = kXyzFromRgb * glm::dvec3(pixel) / white;
        c[0].push_back(116.0 * n.y - 16.0);
        c[1].push_back(500.0 * (n.x - n.y));
        c[2].push_back(200.0 * (n.y - n.z));
        luminance.push_back(n.y);
    }
    const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * pi * pi)) * kPixelsPerDegree));
    const auto gaussian = [](double a, double b, int i, int j) {
        const double d2 = (i * i + j * j) / (kPixelsPerDegree * kPixelsPerDegree);
        return a * std::sqrt(pi / b) * std::exp(-pi * pi * d2 / b);
    };
    c[0] = filterNormalized(c[0], radius, [&](int i, int j) { return gaussian(1.0, 0.0047, i, j); });
    c[1] = filterNormalized(c[1], radius, [&](int i, int j) { return gaussian(1.0, 0.0053, i, j); });
    c[2] = filterNormalized(c[2], radius,
                            [&](int i, int j) { return gaussian(34.1, 0.04, i, j) + gaussian(13.5, 0.025, i, j); });
    for (std::size_t p = 0; p < luminance.size(); ++p) {
        const double y = (c[0][p] + 16.0) / 116.0;
        const glm::dvec3 rgb = glm::clamp(
            glm::inverse(kXyzFromRgb) * (glm::dvec3(y + c[1][p] / 500.0, y, y - c[2][p] / 200.0) * white), 0.0, 1.0);
        glm::dvec3 f = kXyzFromRgb * rgb / white;
        for (int k = 0; k < 3; ++k) {
            f[k] = f[k] > 216.0 / 24389.0 ? std::cbrt(f[k]) : f[k] * 841.0 / 108.0 + 4.0 / 29.0;
        }
        c[0][p] = 116.0 * f.y - 16.0;
        c[1][p] = c[0][p] / 100.0 * 500.0 * (f.x - f.y);
        c[2][p] = c[0][p] / 100.0 * 200.0 * (f.y - f.z);
    }
    return {c[0], c[1], c[2], luminance};
}

Map directFlip(const Image& image, const Image& reference) {
    const Direct direct{image.width, image.height};
    const auto a = direct.perceive(image);
    const auto r = direct.perceive(reference);
    const auto featuresA = direct.features(a[3]);
    const auto featuresR = direct.features(r[3]);
    const double largest = std::pow(kLargestHyab, 0.7);
    Map map;
    for (std::size_t p = 0; p < image.pixels.size(); ++p) {
        const double d = std::abs(a[0][p] - r[0][p]) + std::hypot(a[1][p] - r[1][p], a[2][p] - r[2][p]);
        const double e = std::pow(d, 0.7);
        const double colour =
            e < 0.4 * largest ? 0.95 / (0.4 * largest) * e : 0.95 + (e - 0.4 * largest) / (0.6 * largest) * 0.05;
        const double feature =
            std::max(std::abs(featuresA[0][p] - featuresR[0][p]), std::abs(featuresA[1][p] - featuresR[1][p]));
        map.push_back(std::pow(colour, 1.0 - std::pow(feature / std::sqrt(2.0), 0.5)));
    }
    return map;
}

} // namespace

TEST_CASE("equal pictures have a FLIP of exactly 0") {
    test::Sequence random(7);
    Image image(40, 30);
    for (glm::vec3& pixel : image.pixels) {
        pixel = {random.unit(), random.unit(), random.unit()};
    }
    CHECK(std::ranges::all_of(flipMap(image, image).values, [](double e) { return e == 0.0; }));
}

// On flat pictures the filters change nothing and there are no features, so that FLIP is the redistributed HyAB
// distance.
TEST_CASE("FLIP of black against white is the redistributed lightness difference of 100") {
    // e = (100 / 203.298)^0.7 = 0.6086 lies above 0.4: 0.95 + (0.6086 - 0.4) / 0.6 * 0.05 = 0.96738.
    const double e = std::pow(100.0 / kLargestHyab, 0.7);
    const double expected = 0.95 + (e - 0.4) / 0.6 * 0.05;
    CHECK(expected == Approx(0.96738).epsilon(1e-5));
    CHECK(meanFlip(flat({1, 1, 1}), flat({0, 0, 0})) == Approx(expected).epsilon(1e-4));
}

TEST_CASE("FLIP of two similar greys is on the steep part of the scale") {
    // L*(0.18) = 49.496, L*(0.2) = 51.837; e = (2.341 / 203.298)^0.7 = 0.04394, times 0.95 / 0.4 = 0.1044.
    const double e = std::pow((lightness(0.2) - lightness(0.18)) / kLargestHyab, 0.7);
    const double expected = e * 0.95 / 0.4;
    CHECK(expected == Approx(0.1044).epsilon(1e-3));
    CHECK(meanFlip(flat(glm::vec3(0.2F)), flat(glm::vec3(0.18F))) == Approx(expected).epsilon(1e-4));
}

TEST_CASE("FLIP of green against blue is 1, the end of the scale") {
    CHECK(meanFlip(flat({0, 1, 0}), flat({0, 0, 1})) == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("FLIP compares displayed colours: radiance above 1 is white, below 0 black") {
    CHECK(meanFlip(flat({1, 1, 1}), flat({50, 2, 1.5F})) == 0.0);
    CHECK(meanFlip(flat({0, 0, 0}), flat({-1, -2, -0.1F})) == 0.0);
}

TEST_CASE("FLIP grows with the difference of flat pictures") {
    double previous = 0.0;
    for (const float grey : {0.101F, 0.11F, 0.15F, 0.3F, 0.6F, 1.0F}) {
        const double error = meanFlip(flat(glm::vec3(grey)), flat(glm::vec3(0.1F)));
        CHECK(error > previous);
        previous = error;
    }
}

TEST_CASE("FLIP is symmetric in its two pictures") {
    const Image a = halves(40);
    const Image b = flat({0.2F, 0.5F, 0.1F}, a.width, a.height);
    CHECK(flipMap(a, b).values == flipMap(b, a).values);
}

TEST_CASE("FLIP detects an edge shifted by a pixel, only near the edge, and more if it is shifted further") {
    const ErrorMap shifted = flipMap(halves(48), halves(49));
    const ErrorMap further = flipMap(halves(48), halves(52));
    CHECK(shifted.at(48, 8) > 0.1);
    CHECK(mean(further, {0, 0, 96, 16}) > mean(shifted, {0, 0, 96, 16}));
    // The widest filter reaches 10 pixels: ceil(3 * sqrt(0.04 / (2 pi^2)) * 67.02) = ceil(9.05).
    for (const int x : {0, 20, 48 - 11, 48 + 11, 80, 95}) {
        INFO("column " << x);
        CHECK(shifted.at(x, 8) < 1e-6);
    }
    CHECK(shifted.at(46, 8) > 0.01); // the black and white pattern is spread by a Gaussian of sigma = 1.03 pixels
}

TEST_CASE("a point that differs weighs more than its filtered colour alone") {
    // One white pixel on black: the colour filters blur it, the point detector responds.
    Image dot(64, 64);
    dot.at(32, 32) = {1, 1, 1};
    const Image black(64, 64);
    const double error = flipMap(dot, black).at(32, 32);
    const double unamplified = [&] {
        // Share of the central pixel after the achromatic filter: 1 / (sum of the Gaussian)^2, sigma in pixels.
        const double sigma = std::sqrt(0.0047 / (2.0 * pi * pi)) * kPixelsPerDegree;
        double sum = 0.0;
        for (int i = -10; i <= 10; ++i) {
            sum += std::exp(-i * i / (2.0 * sigma * sigma));
        }
        const double e = std::pow(lightness(1.0 / (sum * sum)) / kLargestHyab, 0.7);
        return e < 0.4 ? e * 0.95 / 0.4 : 0.95 + (e - 0.4) / 0.6 * 0.05;
    }();
    CHECK(error > unamplified * 1.01);
}

TEST_CASE("FLIP agrees with the formulas of the paper written out in two dimensions") {
    test::Sequence random(2020);
    Image image(23, 17);
    Image reference(23, 17);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        // Blocks of noise beside smooth ramps, so that filters, edges and points all have work.
        const float ramp = static_cast<float>(i % 23) / 23.0F;
        reference.pixels[i] = i % 5 == 0 ? glm::vec3(random.unit(), random.unit(), random.unit()) : glm::vec3(ramp);
        image.pixels[i] = i > 200 ? glm::vec3(random.unit(), ramp, 0.3) : 0.9F * reference.pixels[i];
    }
    const Map expected = directFlip(image, reference);
    const ErrorMap map = flipMap(image, reference);
    double largest = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        largest = std::max(largest, std::abs(map.values[i] - expected[i]));
        sum += expected[i];
    }
    CHECK(sum / static_cast<double>(expected.size()) > 0.05); // the pictures do differ
    // The four-decimal matrix moves a colour by some 1e-4 of its range.
    CHECK(largest < 1e-3);
}
