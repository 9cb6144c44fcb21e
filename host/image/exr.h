// OpenEXR files in memory; use them through writeImage() and readImage().
#pragma once

#include "image/image_io.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace hyalite {

[[nodiscard]] bool looksLikeExr(std::span<const std::byte> file);

// 32-bit float, ZIP; layers of one size within the limits of image_io.h. Throws std::exception where OpenEXR refuses,
// e.g. for a metadata key that OpenEXR itself uses with another type.
[[nodiscard]] std::vector<std::byte> encodeExr(std::span<const Layer> layers, const Metadata& metadata);

// Throws Error(BadInput) that names `fileName`.
[[nodiscard]] Image decodeExr(std::span<const std::byte> file, const std::string& fileName);

} // namespace hyalite
