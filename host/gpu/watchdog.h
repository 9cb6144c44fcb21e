// Handles a device that never finishes: the wait ends with an error that names the stage.
#pragma once

#include "gpu/context.h"

#include <cstdint>
#include <limits>

namespace hyalite::gpu {

struct Watchdog {
    // Longest time that one command list may take [s]: the work between two finish() calls is part of a pass and takes
    // seconds, on slow machines minutes.
    double limit = 1800;
    // Called with what hangs. If it returns, or is empty, an Error(Device) is thrown; but unwinding then waits for the
    // device again.
    std::function<void(const std::string& what)> onStuck;
};

// Converts seconds to Vulkan's nanoseconds; more than fits (584 years) means forever. Negative values and NaN mean
// zero.
[[nodiscard]] constexpr std::uint64_t nanoseconds(double seconds) {
    constexpr double kEnd = 0x1p64; // a conversion of this or more would be undefined
    const double wait = 1e9 * seconds;
    return wait >= kEnd ? std::numeric_limits<std::uint64_t>::max() : wait > 0 ? static_cast<std::uint64_t>(wait) : 0;
}

// Sets the watchdog for all commands of the context from now on.
void setWatchdog(const Context& context, Watchdog watchdog);

} // namespace hyalite::gpu
