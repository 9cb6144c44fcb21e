// What a Context holds. Members are in order of creation, so that they are destroyed in reverse.
#pragma once

#include "gpu/buffer.h"
#include "gpu/context.h"
#include "gpu/vulkan.h"
#include "gpu/watchdog.h"

#include <atomic>
#include <map>
#include <span>

namespace hyalite::gpu {

struct ValidationLog {
    std::atomic<std::uint32_t> messages = 0;
    std::function<void(const std::string&)> handler;
};

struct ListedBuffer {
    std::string name;
    std::size_t bytes = 0;
    const Buffer::Impl* buffer = nullptr;
    std::vector<std::byte> copy; // for memoryAt, where the host does not see the buffer
};

class Staging;

struct Context::Impl {
    ValidationLog log;
    DeviceInfo info;
    std::unique_ptr<vk::raii::Context> loader;
    vk::raii::Instance instance = nullptr;
    vk::raii::DebugUtilsMessengerEXT messenger = nullptr;
    vk::raii::PhysicalDevice physical = nullptr;
    std::uint32_t queueFamily = 0;
    std::uint32_t workers = 1; // threads of the CPU that each take a block of a dispatch's groups; of a GPU one
    vk::raii::Device device = nullptr;
    vk::raii::Queue queue = nullptr;
    std::unique_ptr<Staging> staging;
    bool staged = false; // see ContextOptions

    vk::PhysicalDeviceLimits limits;
    vk::DeviceSize maxAllocation = 0;              // bytes of one memory allocation and of one buffer
    bool memoryBudget = false;                     // VK_EXT_memory_budget says how much of a heap is free
    std::uint64_t timestampMask = 0;               // the bits of a timestamp that count
    double secondsPerTick = 0;                     // of a timestamp
    std::map<std::uint64_t, ListedBuffer> buffers; // that exist, by device address
    Watchdog watchdog;

    // Blocks until the fence signals. `stages`: what runs, for the watchdog's error.
    void wait(const vk::raii::Fence& fence, const std::string& stages) const;
    void nameObject(vk::ObjectType type, std::uint64_t handle,
                    const std::string& name) const; // for validation messages
};

// Null when the machine has no Vulkan loader.
[[nodiscard]] std::unique_ptr<vk::raii::Context> openLoader();

// One device as it stands in the loader's list.
[[nodiscard]] DeviceInfo describe(const vk::raii::PhysicalDevice& physical);

// The first queue family that computes.
[[nodiscard]] std::uint32_t computeQueueFamily(const vk::raii::PhysicalDevice& physical);

} // namespace hyalite::gpu
