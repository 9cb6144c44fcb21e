// The film's arithmetic: means and their standard errors from passes that are dealt to two camera sequences.
#include "reference/film/film.h"

#include "unit/reference/support.h"

#include <cmath>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

bool seeksNone(std::uint32_t /*pixel*/, std::uint32_t /*pass*/) {
    return false;
}

} // namespace

TEST_CASE("one pass gives no error estimate, and no pass is black") {
    Film film(2, 1, seeksNone);
    CHECK(film.mean().picture.pixels == std::vector<glm::vec3>(2, glm::vec3(0)));
    CHECK(!film.error().error);
    film.addPass([](std::uint32_t) { return dvec3(1); });
    CHECK(!film.error().error);
    CHECK(!film.mean().error);
    CHECK(film.mean().picture.pixels[1] == glm::vec3(1));
}

TEST_CASE("the error of two passes is half their difference") {
    // A = 1, B = 3: (A - B)^2 n m / (n + m)^2 = 4 / 4 = 1, about a mean of 2; the other pixel has no error.
    Film film(2, 1, seeksNone);
    film.addPass([](std::uint32_t pixel) { return dvec3(pixel == 0 ? 1 : 5); });
    film.addPass([](std::uint32_t pixel) { return dvec3(pixel == 0 ? 3 : 5); });
    const LayeredImage image = film.mean();
    REQUIRE(image.error.has_value());
    CHECK(image.picture.pixels[0] == glm::vec3(2));
    CHECK(image.error->pixels[0] == glm::vec3(1));
    CHECK(image.error->pixels[1] == glm::vec3(0));
    // The mean over both pixels of 1 / (2^2 + 0.01) and 0
    CHECK_THAT(film.error().error.value(), WithinRel(std::sqrt(0.5 / 4.01), 1e-12));
}

TEST_CASE("a black pixel that sought light has an unknown error") {
    // Pixels 0 and 1 are black, pixel 0 sought light; the third is 2 without scatter. Pixel 0 counts 0.01 / 0.01 = 1.
    Film film(3, 1, [](std::uint32_t pixel, std::uint32_t /*pass*/) { return pixel == 0; });
    for (int pass = 0; pass < 2; ++pass) {
        film.addPass([](std::uint32_t pixel) { return dvec3(pixel == 2 ? 2 : 0); });
    }
    CHECK(film.error().darkPixels == 1);
    CHECK_THAT(film.error().error.value(), WithinRel(std::sqrt(1.0 / 3), 1e-12));
    CHECK(film.mean().error->pixels[0] == glm::vec3(0.1F));
    CHECK(film.mean().error->pixels[1] == glm::vec3(0));
}

TEST_CASE("a black picture has no error estimate") {
    Film film(1, 1, [](std::uint32_t /*pixel*/, std::uint32_t /*pass*/) { return true; });
    for (int pass = 0; pass < 2; ++pass) {
        film.addPass([](std::uint32_t /*pixel*/) { return dvec3(0); });
    }
    CHECK(!film.error().error);
    CHECK(film.error().darkPixels == 1);
}

TEST_CASE("an odd number of passes weighs each sequence by its passes") {
    // First sequence 1, 2, 6: mean 3, n = 3. Second 5, 9: mean 7, m = 2. (3 - 7)^2 * 3 * 2 / 25 = 3.84; mean 23/5.
    Film film(1, 1, seeksNone);
    for (const double value : {1, 5, 2, 9, 6}) {
        film.addPass([&](std::uint32_t) { return dvec3(value, 0, 2 * value); });
    }
    const LayeredImage image = film.mean();
    CHECK_THAT(image.picture.pixels[0].x, WithinRel(4.6, 1e-6));
    CHECK_THAT(image.error->pixels[0].x, WithinRel(std::sqrt(3.84), 1e-6));
    CHECK(image.error->pixels[0].y == 0);
    CHECK_THAT(image.error->pixels[0].z, WithinRel(2 * std::sqrt(3.84), 1e-6));
    const double expected = (3.84 / (4.6 * 4.6 + 0.01) + 4 * 3.84 / (9.2 * 9.2 + 0.01)) / 3;
    CHECK_THAT(film.error().error.value(), WithinRel(std::sqrt(expected), 1e-12));
}

TEST_CASE("the error is that of the sum of the layers that hold light") {
    LayeredFilm film(1, 1, {{"direct"}, {"radius", /*isLight*/ false}, {"indirect"}}, seeksNone);
    film.addPass([](std::uint32_t) { return std::vector{dvec3(1), dvec3(7), dvec3(2)}; });
    film.addPass([](std::uint32_t) { return std::vector{dvec3(2), dvec3(9), dvec3(3)}; });
    CHECK(film.mean().picture.pixels[0] == glm::vec3(4)); // of 3 and 5
    CHECK(film.mean().error->pixels[0] == glm::vec3(1));
}

TEST_CASE("the estimated variance of the mean is that of independent passes") {
    // n + m passes, each uniform in [0, 1): the mean has the variance (1/12) / (n + m) whatever the dealing. One degree
    // of freedom a pixel and channel: over the 3 * 40000 of them the relative standard deviation of the estimated
    // variance is sqrt(2 / 120000) = 0.41 %. Six of these.
    constexpr std::uint32_t kSide = 200;
    Random random;
    std::vector<dvec3> values(std::size_t{kSide} * kSide);
    Film film(kSide, kSide, seeksNone);
    std::uint32_t done = 0;
    for (const std::uint32_t passes : {2U, 5U, 16U}) {
        for (; done < passes; ++done) {
            for (dvec3& value : values) {
                value = {random.unit(), random.unit(), random.unit()};
            }
            film.addPass([&](std::uint32_t pixel) { return values[pixel]; });
        }
        const LayeredImage image = film.mean();
        double variance = 0;
        for (const glm::vec3& error : image.error->pixels) {
            variance += glm::dot(dvec3(error), dvec3(error)) / 3 / (kSide * kSide);
        }
        CHECK_THAT(variance, WithinRel(1.0 / 12 / passes, 0.025));
    }
}
