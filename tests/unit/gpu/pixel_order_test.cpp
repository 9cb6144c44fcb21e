// The order in which threads take pixels: tile by tile, and each once, whatever the picture's size.
#include "shaders/shared/pixel_order.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <vector>

using namespace hyalite::shared;

namespace {

std::vector<uint> order(uint width, uint count) {
    std::vector<uint> pixels(count);
    for (uint i = 0; i < count; ++i) {
        pixels[i] = pixelOfThread(i, i / (kTileSide * width), width, count);
    }
    return pixels;
}

} // namespace

TEST_CASE("threads take every pixel of a picture once") {
    const uint width = GENERATE(1U, 2U, 3U, 4U, 5U, 7U, 8U, 13U, 64U, 1023U);
    const uint height = GENERATE(1U, 3U, 4U, 5U, 16U, 23U);
    for (const uint count : {width * height, width * height - width / 2}) { // the second: no picture, but a permutation
        std::vector<uint> pixels = order(width, count);
        std::ranges::sort(pixels);
        for (uint i = 0; i < count; ++i) {
            REQUIRE(pixels[i] == i);
        }
    }
}

TEST_CASE("sixteen threads in a row take a tile of four by four pixels") {
    const uint width = 21; // five tiles, and a column beside them
    const std::vector<uint> pixels = order(width, width * 10);
    for (uint tile = 0; tile < 10; ++tile) { // of two bands
        const uint band = tile / 5;
        const uint first = band * 4 * width + tile % 5 * 4;
        for (uint i = 0; i < 16; ++i) {
            CHECK(pixels[band * 4 * width + tile % 5 * 16 + i] == first + i / 4 * width + i % 4);
        }
    }
    CHECK(pixels[80] == 20); // the column, from the top
    CHECK(pixels[81] == 41);
    CHECK(pixels[168] == 168); // rows 8 and 9, below the last whole band
}

TEST_CASE("threads beyond the end of a picture keep their number") {
    CHECK(pixelOfThread(100, 2, 10, 100) == 100);
}
