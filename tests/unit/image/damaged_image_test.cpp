// Damaged picture files: every prefix and thousands of changed bytes. The result is a picture or an Error, and the
// reader does not trust a header with a wrong size.
#include "base/error.h"
#include "image/exr.h"
#include "image/image_io.h"
#include "image/png.h"
#include "unit/image/encoded_files.h"
#include "unit/image/temporary_folder.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace hyalite;
using namespace hyalite::test;

namespace {

using Decoder = Image (*)(std::span<const std::byte>, const std::string&);

// A copy of exactly the file's length, so that a sanitizer sees one byte too many read.
bool decodes(Decoder decode, const std::string& file) {
    const std::vector<char> exact(file.begin(), file.end());
    try {
        const Image image = decode(std::as_bytes(std::span(exact)), "damaged");
        REQUIRE(image.width >= 1);
        REQUIRE(image.height >= 1);
        return true;
    } catch (const Error& error) {
        REQUIRE(error.code() == ExitCode::BadInput);
        REQUIRE(error.where().file == "damaged");
        return false;
    }
}

float wavy(int x, int y, std::size_t c) {
    return static_cast<float>(std::sin(x + 2 * y + 3 * static_cast<int>(c)));
}

Imf::Header headerWith(Imf::Compression compression) {
    Imf::Header header(11, 9);
    header.compression() = compression;
    return header;
}

// Noisy lines of an 11 x 9 RGB picture, using PNG's five filters in turn.
std::string pngLines() {
    Sequence random(5);
    std::string lines;
    for (int y = 0; y < 9; ++y) {
        lines += static_cast<char>(y % 5);
        for (int x = 0; x < 33; ++x) {
            lines += static_cast<char>(random() & 0xffU);
        }
    }
    return lines;
}

std::string mutated(std::string file, Sequence& random, std::size_t begin) {
    const std::size_t changes = 1 + random.below(3);
    for (std::size_t i = 0; i < changes; ++i) {
        file[begin + random.below(file.size() - begin)] = static_cast<char>(random() & 0xffU);
    }
    return file;
}

const std::vector<Imf::Compression> kCompressions{
    Imf::NO_COMPRESSION,    Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,  Imf::PIZ_COMPRESSION,
    Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION, Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION};

} // namespace

TEST_CASE("every prefix of a PNG file is an error") {
    const std::string file = pngFile({11, 9}, deflated(pngLines()));
    REQUIRE(decodes(decodePng, file));
    for (std::size_t length = 0; length < file.size(); ++length) {
        INFO("first " << length << " of " << file.size() << " bytes");
        if (length >= 8) { // below, it is not even known for a PNG file
            REQUIRE_FALSE(decodes(decodePng, file.substr(0, length)));
        }
        REQUIRE_FALSE(looksLikePng(std::as_bytes(std::span(file).first(std::min<std::size_t>(length, 7)))));
    }
}

TEST_CASE("a PNG file with one changed byte is an error: each is under a checksum") {
    const std::string file = pngFile({11, 9}, deflated(pngLines()));
    for (std::size_t i = 8; i < file.size(); ++i) {
        std::string changed = file;
        changed[i] = static_cast<char>(changed[i] ^ 0x10);
        INFO("byte " << i);
        REQUIRE_FALSE(decodes(decodePng, changed));
    }
}

TEST_CASE("PNG data damaged beneath sound checksums gives a picture or an error") {
    Sequence random(77);
    const std::string data = deflated(pngLines());
    int errors = 0;
    for (int i = 0; i < 3000; ++i) {
        INFO("mutation " << i);
        const PngHeader header{11, 9, i % 2 == 0 ? 8 : 16, i % 7};
        errors += decodes(decodePng, pngFile(header, mutated(data, random, 0))) ? 0 : 1;
    }
    CHECK(errors > 0);
}

TEST_CASE("a PNG header that promises more than its data is an error, without allocating memory for it") {
    const std::string data = deflated(pngLines());
    for (const PngHeader& header :
         {PngHeader{12, 9}, PngHeader{11, 10}, PngHeader{10000, 10000}, PngHeader{65536, 2048}, PngHeader{0, 9},
          PngHeader{11, 0}, PngHeader{0xffffffffU, 1}, PngHeader{0x7fffffffU, 0x7fffffffU}, PngHeader{65536, 65536},
          PngHeader{65537, 1}}) {
        INFO(header.width << " x " << header.height);
        REQUIRE_FALSE(decodes(decodePng, pngFile(header, data)));
    }
    REQUIRE_FALSE(decodes(decodePng, pngFile({11, 9}, "")));
    REQUIRE_FALSE(decodes(decodePng, pngFile({11, 9}, data.substr(0, data.size() / 2))));
}

TEST_CASE("every prefix of an EXR file is an error") {
    for (const Imf::Compression compression : {Imf::ZIP_COMPRESSION, Imf::NO_COMPRESSION}) {
        const std::string file = exrFile(headerWith(compression), {"R", "G", "B"}, Imf::FLOAT, wavy);
        REQUIRE(decodes(decodeExr, file));
        for (std::size_t length = 0; length < file.size(); ++length) {
            INFO("first " << length << " of " << file.size() << " bytes");
            REQUIRE_FALSE(decodes(decodeExr, file.substr(0, length)));
        }
    }
}

TEST_CASE("EXR files with changed bytes give a picture or an error") {
    Sequence random(99);
    int errors = 0;
    for (const bool tiled : {false, true}) {
        for (const Imf::Compression compression : kCompressions) {
            const std::string file = exrFile(headerWith(compression), {"R", "G", "B"}, Imf::HALF, wavy, tiled);
            REQUIRE(decodes(decodeExr, file));
            for (int i = 0; i < 200; ++i) {
                INFO("compression " << compression << ", tiled " << tiled << ", mutation " << i);
                errors += decodes(decodeExr, mutated(file, random, 4)) ? 0 : 1; // the magic number stays
            }
        }
    }
    CHECK(errors > 0);
}

TEST_CASE("EXR windows of absurd or no size are errors") {
    const std::string file = exrFile(headerWith(Imf::ZIP_COMPRESSION), {"R", "G", "B"}, Imf::FLOAT, wavy);
    for (const char* name : {"dataWindow", "displayWindow"}) {
        // Name, type "box2i" and size (4 bytes) stand before xMin, yMin, xMax, yMax, each little-endian.
        const std::size_t box = file.find(name) + std::string(name).size() + 1 + sizeof("box2i") + 4;
        for (const std::array<std::int32_t, 4>& window : {std::array<std::int32_t, 4>{0, 0, 65535, 65535},
                                                          {0, 0, 65536, 0},
                                                          {5, 0, 4, 8},
                                                          {0, 9, 10, 8},
                                                          {-2147483647 - 1, 0, 2147483647, 0},
                                                          {0, -2147483647 - 1, 10, 2147483647}}) {
            std::string changed = file;
            std::memcpy(changed.data() + box, window.data(), sizeof window);
            INFO(name << " to " << window[2] << ", " << window[3]);
            REQUIRE_FALSE(decodes(decodeExr, changed));
        }
    }
}
