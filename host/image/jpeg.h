// JPEG files in memory, for the textures of glTF files; only read.
#pragma once

#include "image/image.h"
#include "image/png.h"

#include <cstddef>
#include <span>
#include <string>

namespace hyalite {

[[nodiscard]] bool looksLikeJpeg(std::span<const std::byte> file);

// Throws Error(BadInput) that names `fileName`.
[[nodiscard]] Image decodeJpeg(std::span<const std::byte> file, const std::string& fileName, Encoding encoding);

} // namespace hyalite
