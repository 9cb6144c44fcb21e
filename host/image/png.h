// PNG files in memory; use them through writeImage() and readImage().
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

// How stored numbers decode to [0, 1]: by the inverse transfer function of sRGB, or linearly.
enum class Encoding { Srgb, Linear };

// Throw Error(BadInput) that names `fileName`; without an encoding: sRGB.
[[nodiscard]] Image decodePng(std::span<const std::byte> file, const std::string& fileName);
[[nodiscard]] Image decodePng(std::span<const std::byte> file, const std::string& fileName, Encoding encoding);

} // namespace hyalite
