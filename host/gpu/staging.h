// Copies between the host and device memory that it does not see.
#pragma once

#include "gpu/buffer_impl.h"

#include <cstddef>
#include <optional>
#include <span>

namespace hyalite::gpu {

class Staging {
public:
    // The context must outlive it.
    explicit Staging(const Context::Impl& context) : context_(context) {}

    // Copy `to` or `from` the buffer, from byte `offset` on, and wait until it is done. What was submitted before is
    // finished then. Throw Error(Device) when the device fails.
    void read(const Buffer::Impl& buffer, std::size_t offset, std::span<std::byte> to);
    void write(const Buffer::Impl& buffer, std::size_t offset, std::span<const std::byte> from);

private:
    // What copies need, made by the first.
    struct Means {
        vk::raii::CommandPool pool = nullptr;
        vk::raii::CommandBuffer commands = nullptr;
        vk::raii::Fence fence = nullptr;
        vk::raii::Buffer buffer = nullptr;
        vk::raii::DeviceMemory memory = nullptr;
        std::byte* mapped = nullptr;
    };
    Means& means();
    void copy(vk::Buffer from, vk::Buffer to, const vk::BufferCopy& region);

    const Context::Impl& context_;
    std::optional<Means> means_;
};

} // namespace hyalite::gpu
