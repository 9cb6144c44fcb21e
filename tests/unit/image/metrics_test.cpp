// The metrics on pictures of a few pixels, with results derived in comments.
#include "image/metrics.h"

#include "base/error.h"
#include "image/error_map.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

using namespace hyalite;
using Catch::Approx;

namespace {

Image row(std::vector<glm::vec3> pixels) {
    Image image(static_cast<int>(pixels.size()), 1);
    image.pixels = std::move(pixels);
    return image;
}

ExitCode codeOf(const Image& image, const Image& reference, const Crop& crop) {
    try {
        requireComparable(image, reference, crop);
    } catch (const Error& error) {
        return error.code();
    }
    return ExitCode::Done;
}

} // namespace

TEST_CASE("RMSE is the root of the mean square over pixels and channels") {
    const Image image = row({{1, 0, 0}, {0, 0.5F, 0}});
    const Image reference = row({{0, 0, 0}, {0, 0.5F, 2}});
    // Differences 1 and 2 among 2 * 3 values: sqrt((1 + 4) / 6).
    CHECK(rmse(image, reference, wholeOf(image)) == Approx(std::sqrt(5.0 / 6.0)).epsilon(1e-14));
}

TEST_CASE("relMSE weighs each square by the reference, the second picture") {
    const Image image = row({{1, 0, 0}, {0, 0.5F, 0}});
    const Image reference = row({{0, 0, 0}, {0, 0.5F, 2}});
    // (1 / 0.01 + 4 / (4 + 0.01)) / 6; with the roles exchanged (1 / (1 + 0.01) + 4 / 0.01) / 6.
    CHECK(relMse(image, reference, wholeOf(image)) == Approx((100.0 + 4.0 / 4.01) / 6.0).epsilon(1e-14));
    CHECK(relMse(reference, image, wholeOf(image)) == Approx((1.0 / 1.01 + 400.0) / 6.0).epsilon(1e-14));
}

TEST_CASE("the largest difference names the first pixel that has it") {
    const Image image = row({{0, 0, 0}, {0, -3, 0}, {3, 0, 0}});
    const Image reference = row({{1, 1, 1}, {0, 0, 0}, {0, 0, 0}});
    const LargestDifference largest = largestDifference(image, reference, wholeOf(image));
    CHECK(largest.value == 3.0);
    CHECK(largest.x == 1);
    CHECK(largest.y == 0);
}

TEST_CASE("a pixel is within the tolerance when every channel is, relative to the reference") {
    const Image reference = row({{1, 1, 1}, {1, 1, 1}, {-2, 0, 4}, {0, 0, 0}, {0, 0, 0}});
    const Image image = row({{1.25F, 0.75F, 1}, {1, 1.26F, 1}, {-2.5F, 0, 3}, {0, 0, 0}, {1e-30F, 0, 0}});
    // At 25 %: the first and third lie just on the bound, the second beyond; black must be black: 3 of 5.
    CHECK(shareWithin(image, reference, 0.25, wholeOf(image)) == Approx(0.6).epsilon(1e-14));
    CHECK(shareWithin(image, reference, 0.0, wholeOf(image)) == Approx(0.2).epsilon(1e-14));
}

TEST_CASE("a crop restricts every metric to its pixels") {
    Image reference(4, 3);
    Image image = reference;
    image.at(0, 0) = {100, 0, 0};
    image.at(2, 1) = {1, 0, 0};
    const Crop crop{1, 1, 2, 2};
    // One channel of 4 * 3 differs by 1.
    CHECK(rmse(image, reference, crop) == Approx(std::sqrt(1.0 / 12.0)).epsilon(1e-14));
    CHECK(relMse(image, reference, crop) == Approx(100.0 / 12.0).epsilon(1e-14));
    CHECK(shareWithin(image, reference, 0.01, crop) == 0.75);
    const LargestDifference largest = largestDifference(image, reference, crop);
    CHECK(largest.value == 1.0);
    CHECK(largest.x == 2); // in the picture's coordinates, not the crop's
    CHECK(largest.y == 1);
}

TEST_CASE("equal pictures have no error, even for huge values") {
    const float huge = std::numeric_limits<float>::max();
    const Image image = row({{huge, -huge, 0}, {1, 2, 3}});
    CHECK(rmse(image, image, wholeOf(image)) == 0.0);
    CHECK(relMse(image, image, wholeOf(image)) == 0.0);
    CHECK(shareWithin(image, image, 0.0, wholeOf(image)) == 1.0);
    // The largest float squared, 1.2e77, is well within double.
    const Image black = row({{0, 0, 0}, {0, 0, 0}});
    CHECK(std::isfinite(relMse(image, black, wholeOf(image))));
}

TEST_CASE("pictures of different sizes and crops outside are wrong usage") {
    const Image image(4, 3);
    CHECK(codeOf(image, Image(3, 4), wholeOf(image)) == ExitCode::WrongUsage);
    CHECK(codeOf(image, image, {0, 0, 4, 3}) == ExitCode::Done);
    CHECK(codeOf(image, image, {3, 2, 1, 1}) == ExitCode::Done);
    for (const Crop& crop : {Crop{0, 0, 5, 3}, Crop{0, 0, 4, 4}, Crop{-1, 0, 2, 2}, Crop{0, -1, 2, 2}, Crop{0, 0, 0, 1},
                             Crop{0, 0, 1, -1}, Crop{1, 0, std::numeric_limits<int>::max(), 1}}) {
        CHECK(codeOf(image, image, crop) == ExitCode::WrongUsage);
    }
    CHECK(codeOf(Image(), Image(), Crop()) == ExitCode::WrongUsage);
}

TEST_CASE("NaN and infinity cannot be compared") {
    const Image good(2, 2);
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Image bad = good;
        bad.at(1, 0).y = value;
        CHECK(codeOf(bad, good, wholeOf(good)) == ExitCode::BadInput);
        CHECK(codeOf(good, bad, wholeOf(good)) == ExitCode::BadInput);
        CHECK_THROWS_AS(rmse(bad, good, wholeOf(good)), Error);
    }
}

TEST_CASE("false colours go from black through red and yellow to white") {
    const ErrorMap map{6, 1, {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0, 7.0, -1.0}};
    const Image image = falseColour(map, {0, 0, 6, 1});
    const std::vector<glm::vec3> expected{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 1, 1}, {0, 0, 0}};
    for (int x = 0; x < 6; ++x) {
        INFO("column " << x);
        CHECK(glm::distance(image.at(x, 0), expected[static_cast<std::size_t>(x)]) < 1e-6F);
    }
    // A crop shows its part of the map.
    CHECK(falseColour(map, {3, 0, 1, 1}).at(0, 0) == image.at(3, 0));
}
