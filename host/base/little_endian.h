// Whole numbers as binary files hold them, the lowest byte first.
#pragma once

#include <cstdint>
#include <string_view>

namespace hyalite {

// The number that `bytes`, at most four, stand for.
[[nodiscard]] inline std::uint32_t littleEndian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        value |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    }
    return value;
}

} // namespace hyalite
