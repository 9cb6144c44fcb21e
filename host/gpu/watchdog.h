// What is done about a device that never finishes: waiting ends, with the name of the stage.
#pragma once

#include "gpu/context.h"

namespace hyalite::gpu {

struct Watchdog {
    // Longest time that one list of commands may take [s]: what is submitted between two finish() is part of a pass,
    // and takes seconds, on slow machines minutes.
    double limit = 1800;
    // Told what hangs. If it returns, or is empty, the same is thrown as Error(Device); but whoever unwinds from there
    // waits for the device again.
    std::function<void(const std::string& what)> onStuck;
};

// For all commands of the context from now on.
void setWatchdog(const Context& context, Watchdog watchdog);

} // namespace hyalite::gpu
