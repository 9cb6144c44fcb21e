// Fowler, Noll and Vo's hash FNV-1a of 64 bits: tells files apart that differ by accident, not by design.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hyalite {

inline constexpr std::uint64_t kFnvStart = 0xcbf29ce484222325U;

// The hash of what came before, given as `state`, followed by `bytes`.
[[nodiscard]] inline std::uint64_t fnv(std::span<const std::byte> bytes, std::uint64_t state = kFnvStart) {
    for (const std::byte byte : bytes) {
        state = (state ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3U;
    }
    return state;
}

} // namespace hyalite
