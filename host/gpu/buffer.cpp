// Buffers, each with an allocation of its own: there are a few dozen, and devices allow thousands.
#include "gpu/buffer_impl.h"
#include "gpu/staging.h"

#include <cstring>
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

// What to look for in memory types, the best first.
struct Wish {
    vk::MemoryPropertyFlags has;
    vk::MemoryPropertyFlags lacks = {};
};

std::vector<Wish> wishesFor(Memory memory) {
    const vk::MemoryPropertyFlags visible = Property::eHostVisible | Property::eHostCoherent;
    if (memory == Memory::Host) {
        return {{.has = visible | Property::eHostCached}, {.has = visible}};
    }
    return {{.has = Property::eDeviceLocal, .lacks = Property::eHostVisible},
            {.has = Property::eDeviceLocal | visible},
            {.has = visible}};
}

// A memory type with room.
std::optional<std::uint32_t> memoryType(const Context::Impl& context, const vk::MemoryRequirements& requirements,
                                        Memory wanted) {
    const vk::PhysicalDeviceMemoryProperties memory = context.physical.getMemoryProperties();
    for (const Wish& wish : wishesFor(wanted)) {
        for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
            const vk::MemoryPropertyFlags properties = memory.memoryTypes[type].propertyFlags;
            const bool allowed = (requirements.memoryTypeBits >> type & 1U) != 0;
            const bool fits = (properties & wish.has) == wish.has && !(properties & wish.lacks);
            if (allowed && fits && requirements.size <= roomInHeap(context, memory.memoryTypes[type].heapIndex)) {
                return type;
            }
        }
    }
    return std::nullopt;
}

// Does the host see what lies there, without calls to make writes seen?
bool isVisible(const Context::Impl& context, std::uint32_t type) {
    const vk::MemoryPropertyFlags visible = Property::eHostVisible | Property::eHostCoherent;
    return (context.physical.getMemoryProperties().memoryTypes[type].propertyFlags & visible) == visible;
}

Error noRoom(const std::string& name, std::size_t bytes, const std::string& why) {
    const double mebibytes = double(bytes) / (1024.0 * 1024.0);
    std::string size = std::to_string(mebibytes);
    size.resize(size.find('.') + 2); // one decimal
    return {ExitCode::Device, "no device memory for '" + name + "' (" + size + " MiB): " + why,
            "lower the resolution or the number of photons"};
}

std::uint32_t requireMemoryType(const Context::Impl& context, const Buffer::Impl& buffer, Memory memory) {
    const vk::MemoryRequirements requirements = buffer.buffer.getMemoryRequirements();
    if (requirements.size > context.maxAllocation) {
        throw noRoom(buffer.name, buffer.bytes, "the device allocates less than that at once");
    }
    const std::optional<std::uint32_t> type = memoryType(context, requirements, memory);
    if (!type) {
        throw noRoom(buffer.name, buffer.bytes, "the device has less than that left");
    }
    return *type;
}

// Gives the buffer its memory, and maps it where the host sees it.
void allocate(const Context::Impl& context, Buffer::Impl& buffer, Memory memory) {
    const std::uint32_t type = requireMemoryType(context, buffer, memory);
    const vk::MemoryAllocateFlagsInfo flags{.flags = vk::MemoryAllocateFlagBits::eDeviceAddress};
    try {
        buffer.memory = {context.device,
                         vk::MemoryAllocateInfo{.pNext = &flags,
                                                .allocationSize = buffer.buffer.getMemoryRequirements().size,
                                                .memoryTypeIndex = type}};
    } catch (const vk::SystemError& error) {
        throw noRoom(buffer.name, buffer.bytes, error.what());
    }
    buffer.buffer.bindMemory(*buffer.memory, 0);
    if (isVisible(context, type) && (memory == Memory::Host || !context.staged)) {
        buffer.mapped = static_cast<std::byte*>(buffer.memory.mapMemory(0, VK_WHOLE_SIZE));
    }
}

void requireWithin(const Buffer& buffer, std::size_t offset, std::size_t bytes) {
    if (offset > buffer.bytes() || bytes > buffer.bytes() - offset) {
        throw Error(ExitCode::BadInput, std::to_string(bytes) + " bytes from " + std::to_string(offset) +
                                            " on of a buffer of " + std::to_string(buffer.bytes()));
    }
}

} // namespace

Buffer::Buffer(const Context& owner, std::size_t bytes, std::string name, Memory memory)
    : impl_(std::make_unique<Impl>()) {
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
                                                          Usage::eShaderDeviceAddress | Usage::eIndirectBuffer |
                                                          Usage::eTransferSrc | Usage::eTransferDst});
        allocate(context, *impl_, memory);
        impl_->address = context.device.getBufferAddress(vk::BufferDeviceAddressInfo{.buffer = *impl_->buffer});
        const auto handle = reinterpret_cast<std::uint64_t>(static_cast<VkBuffer>(*impl_->buffer));
        context.nameObject(vk::ObjectType::eBuffer, handle, impl_->name);
    });
    context.buffers[impl_->address] = {.name = impl_->name, .bytes = bytes, .buffer = impl_.get(), .copy = {}};
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
    return impl_ && impl_->mapped != nullptr ? std::span(impl_->mapped, impl_->bytes) : std::span<std::byte>();
}

void Buffer::read(std::span<std::byte> to, std::size_t offset) const {
    requireWithin(*this, offset, to.size());
    if (to.empty()) {
        return;
    }
    if (impl_->mapped != nullptr) {
        std::memcpy(to.data(), impl_->mapped + offset, to.size());
        return;
    }
    impl_->owner->staging->read(*impl_, offset, to);
}

void Buffer::write(std::span<const std::byte> from, std::size_t offset) const {
    requireWithin(*this, offset, from.size());
    if (from.empty()) {
        return;
    }
    if (impl_->mapped != nullptr) {
        std::memcpy(impl_->mapped + offset, from.data(), from.size());
        return;
    }
    impl_->owner->staging->write(*impl_, offset, from);
}

void refuseHostAccess(const Buffer& buffer) {
    throw Error(ExitCode::BadInput, "the host does not see the memory of '" + buffer.impl()->name + '\'',
                "read() and write() copy it");
}

} // namespace hyalite::gpu
