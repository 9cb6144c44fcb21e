// Pictures in files: PNG to look at (8 bits, sRGB), OpenEXR to compute with (32-bit float, linear).
#pragma once

#include "image/image.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace hyalite {

// How a picture was made, e.g. {"software", "hyalite 0.1.0"}, {"seed", "1"}. Stored as string attributes
// of an EXR file, in the order of the keys; a PNG file holds none.
using Metadata = std::map<std::string, std::string>;

// One picture of a file. The layer named "" is the picture itself (channels R, G, B); others, such as "direct", stand
// beside it in an EXR file (channels direct.R, direct.G, direct.B).
struct Layer {
    std::string name;
    const Image& image;
};

// The largest picture read or written: sides in pixels, and their product.
inline constexpr int kMaxImageSide = 65536;
inline constexpr std::size_t kMaxImagePixels = std::size_t{1} << 27U;

// Number of pixels with a NaN or an infinity in any channel.
[[nodiscard]] std::size_t countNotFinite(const Image& image);

// Writes the layers to a file, in one step (writeFileAtomically). The extension chooses the format:
//   .png  the layer "" alone, clipped to [0, 1], sRGB transfer function, rounded to the nearest of 256 values
//   .exr  every layer, 32-bit float, bit for bit; ZIP compression
// All layers have one size. Throws Error(WrongUsage) for another extension and Error(OutputNotWritten) for what cannot
// be written, such as a value that is not finite; then no file is written.
void writeImage(const std::filesystem::path& path, std::span<const Layer> layers, const Metadata& metadata);
void writeImage(const std::filesystem::path& path, const Image& image, const Metadata& metadata);

// Throws what writeImage() would throw for this path now, without writing: to be called before a long computation.
void checkImageWritable(const std::filesystem::path& path);

// Reads a PNG file (8 or 16 bits a channel, taken as sRGB whatever its profile says; alpha is dropped) or an EXR file
// (channels R, G, B of the first part, as large as its display window; black where it holds no data). The content
// decides, not the name. Throws Error(BadInput) for anything else, damaged files and pictures beyond the limits above.
[[nodiscard]] Image readImage(const std::filesystem::path& path);

} // namespace hyalite
