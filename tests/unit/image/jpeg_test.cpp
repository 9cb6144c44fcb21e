// JPEG files as used by textures.
#include "image/jpeg.h"

#include "base/error.h"
#include "image/srgb.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <stb/stb_image_write.h>
#include <vector>

using namespace hyalite;
using Catch::Matchers::WithinAbs;

namespace {

// 16 x 8 pixels, the left half of one colour and the right half of another: whole blocks, which keep their colour.
std::vector<std::byte> twoColors() {
    std::vector<unsigned char> samples;
    for (int i = 0; i < 16 * 8; ++i) {
        const bool isLeft = i % 16 < 8;
        samples.push_back(isLeft ? 200 : 40);
        samples.push_back(isLeft ? 100 : 80);
        samples.push_back(isLeft ? 50 : 220);
    }
    std::vector<std::byte> file;
    const auto append = [](void* context, void* data, int size) {
        const auto* bytes = static_cast<const std::byte*>(data);
        auto& out = *static_cast<std::vector<std::byte>*>(context);
        out.insert(out.end(), bytes, bytes + size);
    };
    REQUIRE(::stbi_write_jpg_to_func(append, &file, 16, 8, 3, samples.data(), 100) != 0);
    return file;
}

} // namespace

TEST_CASE("a JPEG file is decoded to linear light or to raw numbers") {
    const std::vector<std::byte> file = twoColors();
    CHECK(looksLikeJpeg(file));
    const Image numbers = decodeJpeg(file, "t.jpg", Encoding::Linear);
    REQUIRE(numbers.width == 16);
    REQUIRE(numbers.height == 8);
    const double step = 2 / 255.0; // the format is lossy: colours are converted to YCbCr and back, with rounding
    CHECK_THAT(numbers.at(2, 3).x, WithinAbs(200 / 255.0, step));
    CHECK_THAT(numbers.at(2, 3).z, WithinAbs(50 / 255.0, step));
    CHECK_THAT(numbers.at(13, 3).y, WithinAbs(80 / 255.0, step));
    const Image light = decodeJpeg(file, "t.jpg", Encoding::Srgb);
    for (std::size_t i = 0; i < light.pixels.size(); ++i) {
        CHECK_THAT(light.pixels[i].x, WithinAbs(linearFromSrgb(double{numbers.pixels[i].x}), 1e-6));
    }
}

TEST_CASE("a JPEG file whose Huffman table has more codes than there are is refused before it is decoded") {
    std::vector<std::byte> file = twoColors();
    const std::array<std::byte, 2> mark{std::byte{0xff}, std::byte{0xc4}};
    const auto table = std::search(file.begin(), file.end(), mark.begin(), mark.end());
    REQUIRE(table != file.end());
    std::fill_n(table + 5, 2, std::byte{0xff}); // two of the sixteen counts: 510 codes at least
    CHECK_THROWS_WITH(decodeJpeg(file, "t.jpg", Encoding::Srgb),
                      Catch::Matchers::ContainsSubstring("more than 256 codes"));
}

TEST_CASE("a damaged JPEG file is refused by name") {
    std::vector<std::byte> file = twoColors();
    file.resize(40); // within its tables
    try {
        static_cast<void>(decodeJpeg(file, "t.jpg", Encoding::Srgb));
        FAIL("it was read");
    } catch (const Error& error) {
        CHECK(error.code() == ExitCode::BadInput);
        CHECK(error.where().file == "t.jpg");
        CHECK(std::string(error.what()).find("JPEG file is corrupt") != std::string::npos);
    }
    CHECK_FALSE(looksLikeJpeg(std::span(file).subspan(1)));
}

TEST_CASE("every prefix of a JPEG file, and files with a changed byte, give a picture or an error") {
    const std::vector<std::byte> file = twoColors();
    const auto decodes = [](const std::vector<std::byte>& bytes) {
        try {
            return decodeJpeg(bytes, "t.jpg", Encoding::Linear).width > 0;
        } catch (const Error& error) {
            REQUIRE(error.code() == ExitCode::BadInput);
            return false;
        }
    };
    int refused = 0;
    for (std::size_t i = 0; i < file.size(); ++i) {
        refused += decodes(std::vector(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(i))) ? 0 : 1;
        for (const unsigned bit : {0U, 3U, 7U}) {
            std::vector<std::byte> changed = file;
            changed[i] ^= std::byte{1} << bit;
            refused += decodes(changed) ? 0 : 1;
        }
    }
    CHECK(refused > 0);
}
