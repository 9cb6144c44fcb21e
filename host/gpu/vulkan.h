// Vulkan's C++ bindings as this folder uses them, and the boundary where their exceptions become ours. Only .cpp files
// of host/gpu include it.
#pragma once

#include <vulkan/vulkan_raii.hpp>

#include "base/error.h"

#include <functional>
#include <string>
#include <utility>

namespace hyalite::gpu {

// For calls whose result may be something other than success. (The library's own check moved between versions.)
inline void requireSuccess(vk::Result result, const char* what) {
    if (result != vk::Result::eSuccess) {
        throw Error(ExitCode::Device, std::string(what) + ": " + vk::to_string(result));
    }
}

// Runs `action`; a failed Vulkan call in it becomes an Error(Device) that begins with `what`.
template <class Action>
decltype(auto) checked(const std::string& what, Action&& action) {
    try {
        return std::invoke(std::forward<Action>(action));
    } catch (const vk::DeviceLostError&) {
        throw Error(ExitCode::Device, what + ": the device is lost",
                    "the driver gave up on it; run again: --resume continues from the last checkpoint");
    } catch (const vk::SystemError& error) {
        throw Error(ExitCode::Device, what + ": " + error.what());
    }
}

} // namespace hyalite::gpu
