// What a Buffer and the texel tables hold.
#pragma once

#include "gpu/buffer.h"
#include "gpu/context_impl.h"

namespace hyalite::gpu {

inline constexpr std::size_t kTexelBytes = 16;

struct Buffer::Impl {
    std::string name;
    std::size_t bytes = 0; // as asked for; the Vulkan buffer is rounded up to whole texels
    vk::raii::DeviceMemory memory = nullptr;
    vk::raii::Buffer buffer = nullptr;
    std::byte* mapped = nullptr; // none where the host does not see it
    std::uint64_t address = 0;
    Context::Impl* owner = nullptr; // that lists this buffer by its address

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl();
};

struct TexelTables::Impl {
    const Context::Impl* context = nullptr;
    Buffer dummy; // one texel of zeros
    vk::raii::DescriptorSetLayout layout = nullptr;
    vk::raii::DescriptorPool pool = nullptr;
    vk::raii::DescriptorSet set = nullptr;
    std::vector<vk::raii::BufferView> views; // one a binding
    std::vector<TexelFormat> formats;        // of the views
    std::vector<std::uint64_t> addresses;    // of what they show

    // Puts a view of the buffer into the set; it must live as long as it is there.
    [[nodiscard]] vk::raii::BufferView show(std::uint32_t binding, const Buffer::Impl& shown, TexelFormat format) const;

    // In the checked build: what kernels know of the buffers, and report of their indices.
    Buffer checks;
    vk::raii::BufferView checksView = nullptr;
    void describeBuffers() const;                                                          // before a dispatch
    [[nodiscard]] std::string indexOutside(const std::vector<std::string>& sources) const; // after it: "" or what was
};

} // namespace hyalite::gpu
