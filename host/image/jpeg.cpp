// See jpeg.h. stb does the decoding.
#include "image/jpeg.h"

#include "base/error.h"
#include "image/image_io.h"
#include "image/srgb.h"

#include <algorithm>
#include <array>
#include <climits>
#include <memory>
#include <stb/stb_image.h>
#include <utility>

namespace hyalite {
namespace {

constexpr std::size_t kPixelsPerBlock = 64;

[[noreturn]] void throwBad(const std::string& fileName, const std::string& what) {
    throw Error(ExitCode::BadInput, SourceLocation{fileName}, "JPEG file is corrupt: " + what);
}

// Huffman tables of more than 256 codes, for which stb_image up to 2.27 overruns its own: a table begins with its
// number and sixteen counts of codes. Looked for wherever a segment of tables might begin, since stb finds segments
// its own way.
bool hasOverfullTable(std::span<const std::byte> file) {
    constexpr std::size_t kCounts = 16;
    constexpr std::size_t kMostCodes = 256;
    for (std::size_t mark = 0; mark + 4 <= file.size(); ++mark) {
        if (file[mark] != std::byte{0xff} || file[mark + 1] != std::byte{0xc4}) {
            continue;
        }
        const auto length =
            std::to_integer<std::size_t>(file[mark + 2]) << 8U | std::to_integer<std::size_t>(file[mark + 3]);
        const std::size_t end = std::min(mark + 2 + length, file.size());
        for (std::size_t at = mark + 4; at < end;) {
            const auto number = std::to_integer<unsigned>(file[at]);
            std::size_t codes = 0;
            for (const std::byte count : file.subspan(at + 1, std::min(kCounts, file.size() - at - 1))) {
                codes += std::to_integer<std::size_t>(count);
            }
            if (number >> 4U > 1 || (number & 15U) > 3) {
                break; // no table, and stb refuses it
            }
            if (codes > kMostCodes) {
                return true;
            }
            at += 1 + kCounts + codes;
        }
    }
    return false;
}

} // namespace

bool looksLikeJpeg(std::span<const std::byte> file) {
    constexpr std::array kStart{std::byte{0xff}, std::byte{0xd8}, std::byte{0xff}};
    return file.size() >= kStart.size() && std::equal(kStart.begin(), kStart.end(), file.begin());
}

Image decodeJpeg(std::span<const std::byte> file, const std::string& fileName, Encoding encoding) {
    if (!std::in_range<int>(file.size())) {
        throw Error(ExitCode::BadInput, SourceLocation{fileName}, "the file is larger than 2 GiB");
    }
    if (hasOverfullTable(file)) {
        throwBad(fileName, "a Huffman table of more than 256 codes");
    }
    const auto* bytes = reinterpret_cast<const unsigned char*>(file.data());
    const int size = static_cast<int>(file.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (::stbi_info_from_memory(bytes, size, &width, &height, &channels) == 0) {
        throwBad(fileName, ::stbi_failure_reason());
    }
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::string dimensions = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    if (pixels > kMaxImagePixels) {
        throw Error(ExitCode::BadInput, SourceLocation{fileName}, "the picture is too large: " + dimensions);
    }
    // A block of 8 x 8 pixels takes at least one bit. Without this a few bytes could ask for gigabytes.
    if (pixels / kPixelsPerBlock / CHAR_BIT > file.size()) {
        throwBad(fileName, dimensions + " do not fit into " + std::to_string(file.size()) + " bytes");
    }
    const auto release = [](unsigned char* samples) { ::stbi_image_free(samples); };
    const std::unique_ptr<unsigned char, decltype(release)> samples(
        ::stbi_load_from_memory(bytes, size, &width, &height, &channels, 3), release);
    if (samples == nullptr) {
        throwBad(fileName, ::stbi_failure_reason());
    }
    Image image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double stored = samples.get()[3 * i + channel] / 255.0;
            image.pixels[i][static_cast<int>(channel)] =
                static_cast<float>(encoding == Encoding::Srgb ? linearFromSrgb(stored) : stored);
        }
    }
    return image;
}

} // namespace hyalite
