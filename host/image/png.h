// PNG files in memory; writeImage() and readImage() are the way in.
#pragma once

#include "image/image.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace hyalite {

[[nodiscard]] bool looksLikePng(std::span<const std::byte> file);

// 8 bits a channel, sRGB; the image must be finite and within the size limits of image_io.h.
[[nodiscard]] std::vector<std::byte> encodePng(const Image& image);

// What the numbers of the file stand for: light by the transfer function of sRGB, or shares of 1 as they are.
enum class Encoding { Srgb, Linear };

// Throw Error(BadInput) that names `fileName`; without an encoding: sRGB.
[[nodiscard]] Image decodePng(std::span<const std::byte> file, const std::string& fileName);
[[nodiscard]] Image decodePng(std::span<const std::byte> file, const std::string& fileName, Encoding encoding);

} // namespace hyalite
