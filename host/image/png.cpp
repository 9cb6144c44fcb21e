// PNG files in memory: stb does the coding; what it lets pass (checksums, sizes that the data cannot fill) is checked
// here.
#include "image/png.h"

#include "base/error.h"
#include "image/image_io.h"
#include "image/srgb.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <zlib.h>

namespace hyalite {
namespace {

constexpr std::array<unsigned char, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

// The most bytes that deflate makes of one: four copies of 258, each for a length and a distance code of one bit.
constexpr std::size_t kMaxDeflateRatio = 1032;

[[noreturn]] void throwBad(const std::string& fileName, const std::string& what) {
    throw Error(ExitCode::BadInput, SourceLocation{fileName}, "PNG file is corrupt: " + what);
}

std::uint32_t bigEndian32(std::span<const std::byte> bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = value << 8U | std::to_integer<std::uint32_t>(bytes[i]);
    }
    return value;
}

const unsigned char* asUnsigned(std::span<const std::byte> bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

// Walks the chunks (length, type, data, CRC of type and data) to IEND and compares the checksums, which stb skips.
void checkChunks(std::span<const std::byte> file, const std::string& fileName) {
    constexpr std::size_t kChunkFrame = 12;
    std::span<const std::byte> rest = file.subspan(kSignature.size());
    while (rest.size() >= kChunkFrame) {
        const std::size_t length = bigEndian32(rest);
        if (length > rest.size() - kChunkFrame) {
            break;
        }
        const std::span<const std::byte> typeAndData = rest.subspan(4, 4 + length);
        const ::uLong checksum = ::crc32(0, asUnsigned(typeAndData), static_cast<::uInt>(typeAndData.size()));
        if (checksum != bigEndian32(rest.subspan(8 + length))) {
            throwBad(fileName, "checksum mismatch");
        }
        if (std::string_view(reinterpret_cast<const char*>(typeAndData.data()), 4) == "IEND") {
            return;
        }
        rest = rest.subspan(kChunkFrame + length);
    }
    throwBad(fileName, "unexpected end of file");
}

void checkSize(std::span<const std::byte> file, const std::string& fileName) {
    int width = 0;
    int height = 0;
    int channels = 0;
    if (::stbi_info_from_memory(asUnsigned(file), static_cast<int>(file.size()), &width, &height, &channels) == 0) {
        throwBad(fileName, ::stbi_failure_reason());
    }
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
    if (width > kMaxImageSide || height > kMaxImageSide || pixels > kMaxImagePixels) {
        throw Error(ExitCode::BadInput, SourceLocation{fileName}, "the picture is too large: " + size);
    }
    // A pixel takes at least one bit. Without this a few bytes could ask for gigabytes.
    if (pixels / CHAR_BIT / kMaxDeflateRatio > file.size()) {
        throwBad(fileName, size + " do not fit into " + std::to_string(file.size()) + " bytes");
    }
}

// The picture from decoded samples of either depth; `scale` is the largest sample.
template <typename Sample>
Image toLinear(const Sample* samples, int width, int height, double scale, Encoding encoding) {
    Image image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double stored = static_cast<double>(samples[3 * i + channel]) / scale;
            image.pixels[i][static_cast<int>(channel)] =
                static_cast<float>(encoding == Encoding::Srgb ? linearFromSrgb(stored) : stored);
        }
    }
    return image;
}

} // namespace

bool looksLikePng(std::span<const std::byte> file) {
    return file.size() >= kSignature.size() &&
           std::equal(kSignature.begin(), kSignature.end(), file.begin(),
                      [](unsigned char a, std::byte b) { return std::byte{a} == b; });
}

std::vector<std::byte> encodePng(const Image& image) {
    std::vector<unsigned char> samples;
    samples.reserve(image.pixels.size() * 3);
    for (const glm::vec3& pixel : image.pixels) {
        for (int channel = 0; channel < 3; ++channel) {
            const double clipped = std::clamp(static_cast<double>(pixel[channel]), 0.0, 1.0);
            samples.push_back(static_cast<unsigned char>(std::lround(srgbFromLinear(clipped) * 255.0)));
        }
    }
    std::vector<std::byte> file;
    const auto append = [](void* context, void* data, int size) {
        const std::span bytes(static_cast<const std::byte*>(data), static_cast<std::size_t>(size));
        auto& out = *static_cast<std::vector<std::byte>*>(context);
        out.insert(out.end(), bytes.begin(), bytes.end());
    };
    if (::stbi_write_png_to_func(append, &file, image.width, image.height, 3, samples.data(), 3 * image.width) == 0) {
        throw std::runtime_error("not enough memory to compress it");
    }
    return file;
}

Image decodePng(std::span<const std::byte> file, const std::string& fileName) {
    return decodePng(file, fileName, Encoding::Srgb);
}

Image decodePng(std::span<const std::byte> file, const std::string& fileName, Encoding encoding) {
    if (!std::in_range<int>(file.size())) {
        throw Error(ExitCode::BadInput, SourceLocation{fileName}, "the file is larger than 2 GiB");
    }
    checkChunks(file, fileName);
    checkSize(file, fileName);

    const int size = static_cast<int>(file.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    const auto release = [](auto* samples) { ::stbi_image_free(samples); };
    if (::stbi_is_16_bit_from_memory(asUnsigned(file), size) != 0) {
        const std::unique_ptr<::stbi_us, decltype(release)> samples(
            ::stbi_load_16_from_memory(asUnsigned(file), size, &width, &height, &channels, 3), release);
        if (samples != nullptr) {
            return toLinear(samples.get(), width, height, 65535.0, encoding);
        }
    } else {
        const std::unique_ptr<::stbi_uc, decltype(release)> samples(
            ::stbi_load_from_memory(asUnsigned(file), size, &width, &height, &channels, 3), release);
        if (samples != nullptr) {
            return toLinear(samples.get(), width, height, 255.0, encoding);
        }
    }
    throwBad(fileName, ::stbi_failure_reason());
}

} // namespace hyalite
