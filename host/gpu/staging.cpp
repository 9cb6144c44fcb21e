#include "gpu/staging.h"

#include <algorithm>
#include <cstring>

namespace hyalite::gpu {
namespace {

// Larger copies are made in parts: two megabytes already hide what starting one costs.
constexpr std::size_t kPart = std::size_t(16) << 20U;

std::uint32_t hostMemoryType(const Context::Impl& context, std::uint32_t allowed) {
    using Property = vk::MemoryPropertyFlagBits;
    const vk::MemoryPropertyFlags visible = Property::eHostVisible | Property::eHostCoherent;
    const vk::PhysicalDeviceMemoryProperties memory = context.physical.getMemoryProperties();
    for (const vk::MemoryPropertyFlags wanted : {visible | Property::eHostCached, visible}) {
        for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
            if ((allowed >> type & 1U) != 0 && (memory.memoryTypes[type].propertyFlags & wanted) == wanted) {
                return type;
            }
        }
    }
    throw Error(ExitCode::Device, context.info.name + " has no memory that the host sees");
}

} // namespace

Staging::Means& Staging::means() {
    if (!means_) {
        Means made;
        made.pool = {context_.device, vk::CommandPoolCreateInfo{.queueFamilyIndex = context_.queueFamily}};
        vk::raii::CommandBuffers buffers(
            context_.device, vk::CommandBufferAllocateInfo{.commandPool = *made.pool, .commandBufferCount = 1});
        made.commands = std::move(buffers.front());
        made.fence = {context_.device, vk::FenceCreateInfo{}};
        using Usage = vk::BufferUsageFlagBits;
        made.buffer = {context_.device,
                       vk::BufferCreateInfo{.size = kPart, .usage = Usage::eTransferSrc | Usage::eTransferDst}};
        const vk::MemoryRequirements requirements = made.buffer.getMemoryRequirements();
        made.memory = {context_.device, vk::MemoryAllocateInfo{
                                            .allocationSize = requirements.size,
                                            .memoryTypeIndex = hostMemoryType(context_, requirements.memoryTypeBits)}};
        made.buffer.bindMemory(*made.memory, 0);
        made.mapped = static_cast<std::byte*>(made.memory.mapMemory(0, VK_WHOLE_SIZE));
        means_ = std::move(made);
    }
    return *means_;
}

void Staging::copy(vk::Buffer from, vk::Buffer to, const vk::BufferCopy& region) {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    const Means& with = means();
    with.commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    const auto barrier = [&](vk::PipelineStageFlags2 before, vk::AccessFlags2 written, vk::PipelineStageFlags2 after,
                             vk::AccessFlags2 access) {
        const vk::MemoryBarrier2 memory{
            .srcStageMask = before, .srcAccessMask = written, .dstStageMask = after, .dstAccessMask = access};
        with.commands.pipelineBarrier2(vk::DependencyInfo{.memoryBarrierCount = 1, .pMemoryBarriers = &memory});
    };
    // After all that was submitted before, and before all that will be
    barrier(Stage::eComputeShader | Stage::eAllTransfer, Access::eShaderWrite | Access::eTransferWrite,
            Stage::eAllTransfer, Access::eTransferRead | Access::eTransferWrite);
    with.commands.copyBuffer(from, to, region);
    barrier(Stage::eAllTransfer, Access::eTransferWrite,
            Stage::eComputeShader | Stage::eDrawIndirect | Stage::eAllTransfer | Stage::eHost,
            Access::eShaderRead | Access::eShaderWrite | Access::eIndirectCommandRead | Access::eTransferRead |
                Access::eTransferWrite | Access::eHostRead);
    with.commands.end();
    const vk::CommandBufferSubmitInfo info{.commandBuffer = *with.commands};
    context_.queue.submit2(vk::SubmitInfo2{.commandBufferInfoCount = 1, .pCommandBufferInfos = &info}, *with.fence);
    context_.wait(with.fence, "copy");
    context_.device.resetFences(*with.fence);
    with.pool.reset();
}

void Staging::read(const Buffer::Impl& buffer, std::size_t offset, std::span<std::byte> to) {
    checked("reading '" + buffer.name + '\'', [&] {
        for (std::size_t at = 0; at < to.size(); at += kPart) {
            const std::size_t bytes = std::min(kPart, to.size() - at);
            copy(*buffer.buffer, *means().buffer, {.srcOffset = offset + at, .dstOffset = 0, .size = bytes});
            std::memcpy(to.data() + at, means().mapped, bytes);
        }
    });
}

void Staging::write(const Buffer::Impl& buffer, std::size_t offset, std::span<const std::byte> from) {
    checked("writing '" + buffer.name + '\'', [&] {
        for (std::size_t at = 0; at < from.size(); at += kPart) {
            const std::size_t bytes = std::min(kPart, from.size() - at);
            std::memcpy(means().mapped, from.data() + at, bytes);
            copy(*means().buffer, *buffer.buffer, {.srcOffset = 0, .dstOffset = offset + at, .size = bytes});
        }
    });
}

} // namespace hyalite::gpu
