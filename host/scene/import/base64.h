// Base64 (RFC 4648), as data URIs have it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace hyalite {

// The bytes that the text stands for, with or without its padding; none when it is not base64.
[[nodiscard]] std::optional<std::string> decodeBase64(std::string_view text);

[[nodiscard]] std::string encodeBase64(std::string_view bytes); // padded

} // namespace hyalite
