// Picture files built in memory, including some that no sane program writes.
#pragma once

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfTileDescription.h>
#include <ImfTiledOutputFile.h>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>
#include <zlib.h>

namespace hyalite::test {

inline std::string bigEndian(std::uint32_t value) {
    std::string bytes;
    for (unsigned shift = 32; shift > 0; shift -= 8) {
        bytes += static_cast<char>(static_cast<unsigned char>(value >> (shift - 8)));
    }
    return bytes;
}

inline std::uint32_t crcOf(const std::string& bytes) {
    return static_cast<std::uint32_t>(
        ::crc32(0, reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<::uInt>(bytes.size())));
}

inline std::string pngChunk(const std::string& type, const std::string& data) {
    return bigEndian(static_cast<std::uint32_t>(data.size())) + type + data + bigEndian(crcOf(type + data));
}

inline std::string deflated(const std::string& bytes) {
    std::vector<unsigned char> out(::compressBound(bytes.size()));
    ::uLongf size = out.size();
    ::compress(out.data(), &size, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)};
}

struct PngHeader {
    std::uint32_t width;
    std::uint32_t height;
    int bits = 8;
    int colourType = 2; // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
};

// `compressed` becomes the IDAT chunk: the deflated lines, each after its filter byte.
inline std::string pngFile(const PngHeader& header, const std::string& compressed) {
    std::string ihdr = bigEndian(header.width) + bigEndian(header.height);
    ihdr += static_cast<char>(header.bits);
    ihdr += static_cast<char>(header.colourType);
    ihdr += std::string(3, '\0'); // deflate, the standard filters, not interlaced
    return std::string("\x89PNG\r\n\x1a\n") + pngChunk("IHDR", ihdr) + pngChunk("IDAT", compressed) +
           pngChunk("IEND", "");
}

class StringOutput final : public Imf::OStream {
public:
    StringOutput() : Imf::OStream("test") {}
    void write(const char c[], int n) override {
        const auto count = static_cast<std::size_t>(n);
        bytes.resize(std::max(bytes.size(), position_ + count));
        std::memcpy(bytes.data() + position_, c, count);
        position_ += count;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t pos) override { position_ = pos; }

    std::string bytes;

private:
    std::size_t position_ = 0;
};

// An EXR file of the header's data window; value(x, y, channel) gives the numbers, stored with each channel's own type.
template <typename Value>
std::string exrFile(Imf::Header header, const std::vector<std::string>& channels, Imf::PixelType type,
                    const Value& value, bool tiled = false) {
    const Imath::Box2i window = header.dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    std::vector<std::vector<float>> floats(channels.size());
    std::vector<std::vector<half>> halves(channels.size());
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                floats[c].push_back(value(window.min.x + x, window.min.y + y, c));
                halves[c].push_back(half(floats[c].back()));
            }
        }
        char* data =
            type == Imf::HALF ? reinterpret_cast<char*>(halves[c].data()) : reinterpret_cast<char*>(floats[c].data());
        const std::size_t size = type == Imf::HALF ? sizeof(half) : sizeof(float);
        header.channels().insert(channels[c], Imf::Channel(type));
        // Slice::Make takes the window's origin into account.
        buffer.insert(channels[c], Imf::Slice::Make(type, data, window, size, size * static_cast<std::size_t>(width)));
    }
    StringOutput stream;
    if (tiled) {
        header.setTileDescription(Imf::TileDescription(4, 4));
        Imf::TiledOutputFile output(stream, header);
        output.setFrameBuffer(buffer);
        output.writeTiles(0, output.numXTiles() - 1, 0, output.numYTiles() - 1);
    } else {
        Imf::OutputFile output(stream, header);
        output.setFrameBuffer(buffer);
        output.writePixels(height);
    }
    return stream.bytes; // the scopes above have closed the file
}

} // namespace hyalite::test
