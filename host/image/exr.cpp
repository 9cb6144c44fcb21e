// OpenEXR files in memory, through OpenEXR's own streams, so that files are read and written by our rules alone.
#include "image/exr.h"

#include "base/error.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <thread>

namespace hyalite {
namespace {

constexpr std::array<const char*, 3> kChannelNames{"R", "G", "B"};

class MemoryOutput final : public Imf::OStream {
public:
    MemoryOutput() : Imf::OStream("picture") {}

    void write(const char c[], int n) override {
        const auto count = static_cast<std::size_t>(n);
        bytes_.resize(std::max(bytes_.size(), position_ + count));
        std::memcpy(bytes_.data() + position_, c, count);
        position_ += count;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t pos) override { position_ = pos; } // OpenEXR goes back to fill in its table of offsets

    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

class MemoryInput final : public Imf::IStream {
public:
    MemoryInput(std::span<const std::byte> bytes, const std::string& fileName)
        : Imf::IStream(fileName.c_str()), bytes_(bytes) {}

    bool read(char c[], int n) override {
        const auto count = static_cast<std::size_t>(n);
        if (n < 0 || position_ > bytes_.size() || count > bytes_.size() - position_) {
            throw std::runtime_error("unexpected end of file");
        }
        std::memcpy(c, bytes_.data() + position_, count);
        position_ += count;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t pos) override { position_ = pos; }

private:
    std::span<const std::byte> bytes_;
    std::uint64_t position_ = 0;
};

// Width and height of a window; throws where it is empty or beyond the limits; computed without overflow.
glm::ivec2 sizeOf(const Imath::Box2i& window) {
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1 || width > kMaxImageSide || height > kMaxImageSide ||
        static_cast<std::size_t>(width * height) > kMaxImagePixels) {
        throw std::runtime_error("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                                 " pixels is too large");
    }
    return {static_cast<int>(width), static_cast<int>(height)};
}

void checkChannels(const Imf::ChannelList& channels) {
    std::string found;
    for (auto it = channels.begin(); it != channels.end(); ++it) {
        found += std::string(found.empty() ? "" : ", ") + it.name();
    }
    for (const char* name : kChannelNames) {
        const Imf::Channel* channel = channels.findChannel(name);
        if (channel == nullptr) {
            throw std::runtime_error("it has no channel " + std::string(name) + ", only: " + found);
        }
        if (channel->xSampling != 1 || channel->ySampling != 1) {
            throw std::runtime_error("channel " + std::string(name) + " is subsampled");
        }
    }
}

// Reads the data window line by line into one line buffer. The picture grows with the data that is really there: a
// header that promises more than the file holds costs no memory.
std::vector<glm::vec3> readData(Imf::InputFile& input, const Imath::Box2i& window, glm::ivec2 size) {
    std::vector<glm::vec3> line(static_cast<std::size_t>(size.x));
    Imf::FrameBuffer buffer;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        // OpenEXR addresses base + x * stride from x = window.min.x on; a line stride of 0 puts every line here. The
        // base may lie outside our array, so it is computed as an integer: such pointer arithmetic is undefined.
        const auto first =
            reinterpret_cast<std::intptr_t>(line.data()) + static_cast<std::intptr_t>(channel * sizeof(float));
        const std::intptr_t base = first - std::intptr_t{window.min.x} * static_cast<std::intptr_t>(sizeof(glm::vec3));
        auto* const origin = reinterpret_cast<char*>(base); // NOLINT(performance-no-int-to-ptr)
        buffer.insert(kChannelNames[channel], Imf::Slice(Imf::FLOAT, origin, sizeof(glm::vec3), 0));
    }
    input.setFrameBuffer(buffer);
    std::vector<glm::vec3> pixels;
    for (int y = 0; y < size.y; ++y) {
        input.readPixels(window.min.y + y);
        pixels.insert(pixels.end(), line.begin(), line.end());
    }
    return pixels;
}

// The display window is the picture; data outside it is not seen, and where it holds no data it is black.
Image placeInDisplay(const std::vector<glm::vec3>& pixels, const Imath::Box2i& data, const Imath::Box2i& display) {
    const glm::ivec2 size = sizeOf(display);
    const glm::ivec2 dataSize = sizeOf(data);
    Image image(size.x, size.y);
    const std::int64_t x0 = std::int64_t{data.min.x} - display.min.x;
    const std::int64_t y0 = std::int64_t{data.min.y} - display.min.y;
    const std::int64_t firstX = std::clamp<std::int64_t>(x0, 0, size.x);
    const std::int64_t lastX = std::clamp<std::int64_t>(x0 + dataSize.x, 0, size.x);
    const std::int64_t firstY = std::clamp<std::int64_t>(y0, 0, size.y);
    const std::int64_t lastY = std::clamp<std::int64_t>(y0 + dataSize.y, 0, size.y);
    for (std::int64_t y = firstY; y < lastY; ++y) {
        for (std::int64_t x = firstX; x < lastX; ++x) {
            image.at(static_cast<int>(x), static_cast<int>(y)) =
                pixels[static_cast<std::size_t>((y - y0) * dataSize.x + (x - x0))];
        }
    }
    return image;
}

// Tells OpenEXR once to refuse headers with absurd sizes before it allocates for them, and to compress with all cores.
void setUpOpenExr() {
    static const bool kDone = [] {
        Imf::setGlobalThreadCount(static_cast<int>(std::thread::hardware_concurrency()));
        Imf::Header::setMaxImageSize(kMaxImageSide, kMaxImageSide);
        Imf::Header::setMaxTileSize(4096, 4096);
        return true;
    }();
    static_cast<void>(kDone);
}

} // namespace

bool looksLikeExr(std::span<const std::byte> file) {
    constexpr std::array kMagic{std::byte{0x76}, std::byte{0x2f}, std::byte{0x31}, std::byte{0x01}};
    return file.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), file.begin());
}

std::vector<std::byte> encodeExr(std::span<const Layer> layers, const Metadata& metadata) {
    setUpOpenExr();
    const Image& first = layers.front().image;
    Imf::Header header(first.width, first.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [key, value] : metadata) {
        header.insert(key, Imf::StringAttribute(value));
    }
    Imf::FrameBuffer buffer;
    for (const Layer& layer : layers) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const std::string name = (layer.name.empty() ? "" : layer.name + '.') + kChannelNames[channel];
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
            // The slice type is shared with reading; writing leaves the pixels alone.
            auto* base = const_cast<float*>(&layer.image.pixels.front()[static_cast<int>(channel)]);
            buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(base), sizeof(glm::vec3),
                                           sizeof(glm::vec3) * static_cast<std::size_t>(first.width)));
        }
    }
    MemoryOutput stream;
    {
        Imf::OutputFile output(stream, header);
        output.setFrameBuffer(buffer);
        output.writePixels(first.height);
    } // the table of offsets is written on closing
    return stream.take();
}

Image decodeExr(std::span<const std::byte> file, const std::string& fileName) {
    setUpOpenExr();
    try {
        MemoryInput stream(file, fileName);
        Imf::InputFile input(stream);
        const Imath::Box2i data = input.header().dataWindow();
        checkChannels(input.header().channels());
        static_cast<void>(sizeOf(input.header().displayWindow()));
        return placeInDisplay(readData(input, data, sizeOf(data)), data, input.header().displayWindow());
    } catch (const std::exception& failure) {
        throw Error(ExitCode::BadInput, SourceLocation{fileName},
                    "cannot read the EXR file: " + std::string(failure.what()));
    }
}

} // namespace hyalite
