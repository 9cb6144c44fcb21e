// What is done about a device that never finishes: waiting ends, with the name of the stage.
#pragma once

#include "gpu/context.h"

#include <cstdint>
#include <limits>

namespace hyalite::gpu {

struct Watchdog {
    // Longest time that one list of commands may take [s]: what is submitted between two finish() is part of a pass,
    // and takes seconds, on slow machines minutes.
    double limit = 1800;
    // Told what hangs. If it returns, or is empty, the same is thrown as Error(Device); but whoever unwinds from there
    // waits for the device again.
    std::function<void(const std::string& what)> onStuck;
};

// A wait of so many seconds as Vulkan counts it; what is longer than it can say (584 years) is without end. A negative
// one, or NaN, is none.
[[nodiscard]] constexpr std::uint64_t nanoseconds(double seconds) {
    constexpr double kEnd = 0x1p64; // a conversion of this or more would be undefined
    const double wait = 1e9 * seconds;
    return wait >= kEnd ? std::numeric_limits<std::uint64_t>::max() : wait > 0 ? static_cast<std::uint64_t>(wait) : 0;
}

// For all commands of the context from now on.
void setWatchdog(const Context& context, Watchdog watchdog);

} // namespace hyalite::gpu
