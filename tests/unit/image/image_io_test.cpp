// PNG and EXR round trips, and every rejected input.
#include "image/image_io.h"

#include "base/error.h"
#include "image/srgb.h"
#include "unit/image/encoded_files.h"
#include "unit/image/temporary_folder.h"

#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <algorithm>
#include <bit>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <functional>
#include <limits>

using namespace hyalite;
using namespace hyalite::test;
using Catch::Approx;

namespace {

// The formula of IEC 61966-2-1 for stored values above 0.04045.
double linearOf(double stored) {
    return std::pow((stored + 0.055) / 1.055, 2.4);
}

Image grey(const std::vector<double>& values) {
    Image image(static_cast<int>(values.size()), 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
        image.pixels[i] = glm::vec3(static_cast<float>(values[i]));
    }
    return image;
}

// Bits, not values: -0 differs from 0.
bool sameBits(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height &&
           std::ranges::equal(a.pixels, b.pixels, [](const glm::vec3& p, const glm::vec3& q) {
               return glm::floatBitsToUint(p) == glm::floatBitsToUint(q);
           });
}

Error errorOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error;
    }
    FAIL("nothing was thrown");
    return {ExitCode::Done, ""};
}

bool says(const Error& error, const std::string& part) {
    return std::string(error.what()).find(part) != std::string::npos;
}

} // namespace

TEST_CASE("the sRGB transfer function has the standard's values") {
    CHECK(srgbFromLinear(0.0) == 0.0);
    CHECK(srgbFromLinear(1.0) == Approx(1.0).epsilon(1e-15));
    CHECK(srgbFromLinear(0.001) == Approx(0.01292).epsilon(1e-14));                    // the linear toe
    CHECK(srgbFromLinear(0.0031308) == Approx(0.040449936).epsilon(1e-9));             // 12.92 * 0.0031308, the join
    CHECK(linearFromSrgb(0.04045) == Approx(0.04045 / 12.92).epsilon(1e-14));          // and back
    CHECK(linearFromSrgb(0.5) == Approx(std::pow(0.555 / 1.055, 2.4)).epsilon(1e-14)); // 0.21404
    CHECK(srgbFromLinear(0.5) == Approx(1.055 * std::pow(0.5, 1.0 / 2.4) - 0.055).epsilon(1e-14));
    for (int i = 0; i <= 1000; ++i) {
        // The standard rounds its constants: the two pieces miss each other by some 1e-8 at the join.
        CHECK(linearFromSrgb(srgbFromLinear(i / 1000.0)) == Approx(i / 1000.0).margin(1e-7));
    }
}

TEST_CASE("a PNG file holds radiance clipped to [0, 1], in sRGB, rounded to the nearest of 256 values") {
    const TemporaryFolder folder;
    // 255 * (1.055 * 0.5^(1/2.4) - 0.055) = 187.5: 188 above it, as 187.516 is.
    writeImage(folder / "a.png", grey({0.5, 2.0, -1.0, 1e30, 0.0}), {});
    const Image image = readImage(folder / "a.png");
    REQUIRE(image.width == 5);
    CHECK(image.at(0, 0).x == Approx(linearOf(188.0 / 255.0)).epsilon(1e-6));
    CHECK(image.at(1, 0) == glm::vec3(1.0F));
    CHECK(image.at(2, 0) == glm::vec3(0.0F));
    CHECK(image.at(3, 0) == glm::vec3(1.0F));
    CHECK(image.at(4, 0) == glm::vec3(0.0F));
}

TEST_CASE("every one of the 256 values of a PNG channel survives, and values between round to the nearer") {
    const TemporaryFolder folder;
    Image image(256, 3);
    Image expected(256, 3);
    const double offsets[3] = {0.0, 0.49, -0.49};
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 256; ++x) {
            const double stored = std::clamp(x + offsets[y], 0.0, 255.0) / 255.0;
            const auto other = static_cast<double>(255 - x) / 255.0;
            image.at(x, y) = glm::dvec3(linearFromSrgb(stored), linearFromSrgb(other), 0.0);
            expected.at(x, y) = glm::dvec3(linearFromSrgb(x / 255.0), linearFromSrgb(other), 0.0);
        }
    }
    writeImage(folder / "a.png", image, {});
    CHECK(sameBits(readImage(folder / "a.png"), expected));
}

TEST_CASE("PNG files of other kinds are read: 16 bits, grey, alpha") {
    const TemporaryFolder folder;
    // One pixel: the filter byte 0, then the samples, most significant byte first.
    put(folder / "16.png", pngFile({1, 1, 16, 2}, deflated(std::string("\0\x80\x01\xff\xff\0\0", 7))));
    const Image deep = readImage(folder / "16.png");
    CHECK(deep.at(0, 0).x == Approx(linearOf(0x8001 / 65535.0)).epsilon(1e-6));
    CHECK(deep.at(0, 0).y == 1.0F);
    CHECK(deep.at(0, 0).z == 0.0F);

    put(folder / "grey.png", pngFile({1, 1, 8, 0}, deflated(std::string("\0\xc8", 2))));
    CHECK(readImage(folder / "grey.png").at(0, 0) == glm::vec3(static_cast<float>(linearOf(200.0 / 255.0))));

    put(folder / "rgba.png", pngFile({1, 1, 8, 6}, deflated(std::string("\0\xff\x80\0\0", 5)))); // transparent
    CHECK(readImage(folder / "rgba.png").at(0, 0).y == Approx(linearOf(128.0 / 255.0)).epsilon(1e-6));
}

TEST_CASE("an EXR file gives back every bit") {
    const TemporaryFolder folder;
    Image image(37, 41); // not a multiple of the 16 lines of a ZIP block
    Sequence random(1);
    for (glm::vec3& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c) {
            do {
                pixel[c] = std::bit_cast<float>(random());
            } while (!std::isfinite(pixel[c]));
        }
    }
    using Limits = std::numeric_limits<float>;
    image.at(0, 0) = {-0.0F, Limits::denorm_min(), Limits::max()};
    image.at(36, 40) = {-Limits::max(), -1.0F, 0.0F};
    writeImage(folder / "a.exr", image, {});
    CHECK(sameBits(readImage(folder / "a.exr"), image));

    writeImage(folder / "b.exr", image, {});
    CHECK(get(folder / "a.exr") == get(folder / "b.exr"));
}

TEST_CASE("an EXR file carries the metadata as attributes and further layers as channels") {
    const TemporaryFolder folder;
    const Image picture = grey({1.0, 2.0});
    const Image direct = grey({0.25, 0.5});
    const std::vector<Layer> layers{{"direct", direct}, {"", picture}};
    writeImage(folder / "a.exr", layers, {{"software", "hyalite 0.1.0"}, {"seed", "18446744073709551615"}});
    CHECK(sameBits(readImage(folder / "a.exr"), picture));

    Imf::InputFile file((folder / "a.exr").c_str());
    CHECK(file.header().typedAttribute<Imf::StringAttribute>("software").value() == "hyalite 0.1.0");
    CHECK(file.header().typedAttribute<Imf::StringAttribute>("seed").value() == "18446744073709551615");
    CHECK(file.header().compression() == Imf::ZIP_COMPRESSION);
    std::string names;
    for (auto it = file.header().channels().begin(); it != file.header().channels().end(); ++it) {
        names += std::string(it.name()) + ' ';
        CHECK(it.channel().type == Imf::FLOAT);
    }
    CHECK(names == "B G R direct.B direct.G direct.R ");
    std::vector<float> line(2);
    Imf::FrameBuffer buffer;
    buffer.insert("direct.G", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(line.data()), sizeof(float), 0));
    file.setFrameBuffer(buffer);
    file.readPixels(0);
    CHECK(line == std::vector<float>{0.25F, 0.5F});

    // A PNG file shows the picture itself.
    writeImage(folder / "a.png", layers, {});
    CHECK(readImage(folder / "a.png").at(0, 0) == glm::vec3(1.0F));
}

TEST_CASE("an EXR picture is its display window: data outside is cut off, and missing data is black") {
    const TemporaryFolder folder;
    // Data columns 8..13, lines -3..3 against a display of columns 10..17, lines 0..5.
    Imf::Header header(Imath::Box2i({10, 0}, {17, 5}), Imath::Box2i({8, -3}, {13, 3}));
    const auto value = [](int x, int y, std::size_t c) {
        return 100.0F * static_cast<float>(x) + 10.0F * static_cast<float>(y) + static_cast<float>(c);
    };
    for (const bool tiled : {false, true}) {
        put(folder / "a.exr", exrFile(header, {"R", "G", "B"}, Imf::HALF, value, tiled));
        const Image image = readImage(folder / "a.exr");
        REQUIRE(image.width == 8);
        REQUIRE(image.height == 6);
        for (int y = 0; y < 6; ++y) {
            for (int x = 0; x < 8; ++x) {
                const bool hasData = x + 10 <= 13 && y <= 3;
                const glm::vec3 expected(value(x + 10, y, 0), value(x + 10, y, 1), value(x + 10, y, 2));
                CHECK(image.at(x, y) ==
                      (hasData ? expected : glm::vec3(0.0F))); // whole numbers below 2048: exact in half
            }
        }
    }
    put(folder / "apart.exr",
        exrFile(Imf::Header(Imath::Box2i({0, 0}, {1, 1}), Imath::Box2i({-1000000000, 5}, {-999999999, 6})),
                {"R", "G", "B"}, Imf::FLOAT, value));
    CHECK(sameBits(readImage(folder / "apart.exr"), Image(2, 2)));
}

TEST_CASE("an EXR file without colour channels is an error that names what it has") {
    const TemporaryFolder folder;
    put(folder / "a.exr",
        exrFile(Imf::Header(2, 2), {"Y", "Z"}, Imf::HALF, [](int, int, std::size_t) { return 1.0F; }));
    const Error error = errorOf([&] { static_cast<void>(readImage(folder / "a.exr")); });
    CHECK(error.code() == ExitCode::BadInput);
    CHECK(says(error, "Y, Z"));
}

TEST_CASE("no NaN reaches a file") {
    const TemporaryFolder folder;
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity()}) {
        Image image(3, 2);
        image.at(1, 1).z = value;
        image.at(2, 1).x = value;
        CHECK(countNotFinite(image) == 2);
        for (const char* name : {"a.png", "a.exr"}) {
            const Error error = errorOf([&] { writeImage(folder / name, image, {}); });
            CHECK(error.code() == ExitCode::OutputNotWritten);
            CHECK(says(error, "2 pixels"));
            CHECK(says(error, "(1, 1)"));
        }
        // Nor in a layer that stands beside a sound picture.
        const Image sound(3, 2);
        const std::vector<Layer> layers{{"", sound}, {"direct", image}};
        CHECK_THROWS_AS(writeImage(folder / "a.exr", layers, {}), Error);
    }
    CHECK(countNotFinite(Image(3, 2)) == 0);
    CHECK(folder.entries() == 0);
}

TEST_CASE("another extension is wrong usage, and is reported before any work") {
    const TemporaryFolder folder;
    for (const char* name : {"a.jpg", "a", "a.png.gz", ".exr"}) {
        CHECK(errorOf([&] { writeImage(folder / name, Image(1, 1), {}); }).code() == ExitCode::WrongUsage);
        CHECK(errorOf([&] { checkImageWritable(folder / name); }).code() == ExitCode::WrongUsage);
    }
    CHECK(errorOf([&] { checkImageWritable(folder / "missing/a.png"); }).code() == ExitCode::OutputNotWritten);
    checkImageWritable(folder / "a.PNG");
    CHECK(folder.entries() == 0);
    writeImage(folder / "a.PNG", Image(1, 1), {});
    writeImage(folder / "a.Exr", Image(1, 1), {});
    CHECK(folder.entries() == 2);
}

TEST_CASE("pictures and layers that cannot form a file are refused") {
    const TemporaryFolder folder;
    const auto refuses = [&](const std::vector<Layer>& layers, const Metadata& metadata = {}) {
        CHECK(errorOf([&] { writeImage(folder / "a.exr", layers, metadata); }).code() == ExitCode::OutputNotWritten);
    };
    const Image one(1, 1);
    const Image two(2, 1);
    const Image empty;
    Image torn(2, 2);
    torn.pixels.pop_back();
    Image wide;
    wide.width = kMaxImageSide + 1;
    wide.height = 1;
    refuses({});
    refuses({{"", empty}});
    refuses({{"", torn}});
    refuses({{"", wide}});
    refuses({{"direct", one}});
    refuses({{"", one}, {"direct", two}});
    refuses({{"", one}, {"", one}});
    refuses({{"", one}}, {{"channels", "taken by OpenEXR itself"}});
    CHECK(folder.entries() == 0);
}

TEST_CASE("a file that is not a picture is an error that names it") {
    const TemporaryFolder folder;
    put(folder / "empty.png", "");
    put(folder / "text.png", "hyalite: 1\n");
    for (const std::filesystem::path& path : {folder / "missing.png", folder.path(), folder / "empty.png",
                                              folder / "text.png", std::filesystem::path("/dev/null")}) {
        const Error error = errorOf([&] { static_cast<void>(readImage(path)); });
        CHECK(error.code() == ExitCode::BadInput);
        CHECK(error.where().file == path.string());
    }
}
