// Buffers, each with an allocation of its own: there are a few dozen, and devices allow thousands.
#include "gpu/buffer_impl.h"

#include <optional>

namespace hyalite::gpu {
namespace {

using Property = vk::MemoryPropertyFlagBits;

// Bytes that heap `index` can still give.
vk::DeviceSize roomInHeap(const Context::Impl& context, std::uint32_t index) {
    if (!context.memoryBudget) {
        return context.physical.getMemoryProperties().memoryHeaps[index].size;
    }
    const auto chain =
        context.physical
            .getMemoryProperties2<vk::PhysicalDeviceMemoryProperties2, vk::PhysicalDeviceMemoryBudgetPropertiesEXT>();
    const auto& budget = chain.get<vk::PhysicalDeviceMemoryBudgetPropertiesEXT>();
    const vk::DeviceSize used = budget.heapUsage[index];
    return budget.heapBudget[index] > used ? budget.heapBudget[index] - used : 0;
}

// A memory type that the host sees and that has room: on the device if there is one, else the host's own.
std::optional<std::uint32_t> memoryType(const Context::Impl& context, const vk::MemoryRequirements& requirements) {
    const vk::PhysicalDeviceMemoryProperties memory = context.physical.getMemoryProperties();
    const vk::MemoryPropertyFlags visible = Property::eHostVisible | Property::eHostCoherent;
    for (const vk::MemoryPropertyFlags wanted : {visible | Property::eDeviceLocal, visible}) {
        for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
            const bool allowed = (requirements.memoryTypeBits >> type & 1U) != 0;
            const bool fits = (memory.memoryTypes[type].propertyFlags & wanted) == wanted;
            if (allowed && fits && requirements.size <= roomInHeap(context, memory.memoryTypes[type].heapIndex)) {
                return type;
            }
        }
    }
    return std::nullopt;
}

Error noRoom(const std::string& name, std::size_t bytes, const std::string& why) {
    const double mebibytes = double(bytes) / (1024.0 * 1024.0);
    std::string size = std::to_string(mebibytes);
    size.resize(size.find('.') + 2); // one decimal
    return {ExitCode::Device, "no device memory for '" + name + "' (" + size + " MiB): " + why,
            "lower the resolution or the number of photons"};
}

vk::raii::DeviceMemory allocate(const Context::Impl& context, const vk::raii::Buffer& buffer, std::size_t bytes,
                                const std::string& name) {
    const vk::MemoryRequirements requirements = buffer.getMemoryRequirements();
    if (requirements.size > context.maxAllocation) {
        throw noRoom(name, bytes, "the device allocates less than that at once");
    }
    const std::optional<std::uint32_t> type = memoryType(context, requirements);
    if (!type) {
        throw noRoom(name, bytes, "the device has less than that left");
    }
    const vk::MemoryAllocateFlagsInfo flags{.flags = vk::MemoryAllocateFlagBits::eDeviceAddress};
    return {context.device,
            vk::MemoryAllocateInfo{.pNext = &flags, .allocationSize = requirements.size, .memoryTypeIndex = *type}};
}

} // namespace

Buffer::Buffer(const Context& owner, std::size_t bytes, std::string name) : impl_(std::make_unique<Impl>()) {
    Context::Impl& context = owner.impl();
    const std::string what = "making buffer '" + name + '\'';
    impl_->name = std::move(name);
    impl_->bytes = bytes;
    if (bytes == 0) {
        throw Error(ExitCode::Device, what + ": a buffer needs at least one byte");
    }
    // Whole texels, so that any buffer may be shown as a table and cleared in words.
    const vk::DeviceSize size = (vk::DeviceSize(bytes) + kTexelBytes - 1) / kTexelBytes * kTexelBytes;
    if (size < bytes || size > context.maxAllocation) {
        throw noRoom(impl_->name, bytes, "the device allocates less than that at once");
    }
    checked(what, [&] {
        using Usage = vk::BufferUsageFlagBits;
        impl_->buffer = vk::raii::Buffer(
            context.device, vk::BufferCreateInfo{.size = size,
                                                 .usage = Usage::eStorageBuffer | Usage::eUniformTexelBuffer |
                                                          Usage::eShaderDeviceAddress | Usage::eTransferDst});
        try {
            impl_->memory = allocate(context, impl_->buffer, bytes, impl_->name);
        } catch (const vk::SystemError& error) {
            throw noRoom(impl_->name, bytes, error.what());
        }
        impl_->buffer.bindMemory(*impl_->memory, 0);
        impl_->mapped = static_cast<std::byte*>(impl_->memory.mapMemory(0, VK_WHOLE_SIZE));
        impl_->address = context.device.getBufferAddress(vk::BufferDeviceAddressInfo{.buffer = *impl_->buffer});
        const auto handle = reinterpret_cast<std::uint64_t>(static_cast<VkBuffer>(*impl_->buffer));
        context.nameObject(vk::ObjectType::eBuffer, handle, impl_->name);
    });
    context.buffers[impl_->address] = {impl_->name, mapped()};
    impl_->owner = &context;
}

Buffer::Impl::~Impl() {
    if (owner != nullptr) {
        owner->buffers.erase(address);
    }
}

Buffer::Buffer() = default;

Buffer::~Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&&) noexcept = default;

std::size_t Buffer::bytes() const {
    return impl_ ? impl_->bytes : 0;
}

std::uint64_t Buffer::address() const {
    return impl_ ? impl_->address : 0;
}

std::span<std::byte> Buffer::mapped() const {
    return impl_ ? std::span(impl_->mapped, impl_->bytes) : std::span<std::byte>();
}

} // namespace hyalite::gpu
