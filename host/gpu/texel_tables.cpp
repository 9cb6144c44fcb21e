// The descriptor set of uniform texel buffers that every kernel is bound with.
#include "gpu/buffer_impl.h"

namespace hyalite::gpu {

TexelTables::TexelTables(const Context& context, std::uint32_t bindings) : impl_(std::make_unique<Impl>()) {
    impl_->context = &context.impl();
    impl_->dummy = Buffer(context, kTexelBytes, "empty texel table");
    std::memset(impl_->dummy.mapped().data(), 0, kTexelBytes);
    checked("making the texel tables", [&] {
        const vk::raii::Device& device = impl_->context->device;
        std::vector<vk::DescriptorSetLayoutBinding> layout(bindings);
        for (std::uint32_t i = 0; i < bindings; ++i) {
            layout[i] = {.binding = i,
                         .descriptorType = vk::DescriptorType::eUniformTexelBuffer,
                         .descriptorCount = 1,
                         .stageFlags = vk::ShaderStageFlagBits::eCompute};
            impl_->views.emplace_back(nullptr);
            impl_->formats.push_back(TexelFormat::Float4);
            impl_->addresses.push_back(0);
        }
        impl_->layout = {device,
                         vk::DescriptorSetLayoutCreateInfo{.bindingCount = bindings, .pBindings = layout.data()}};
        const vk::DescriptorPoolSize size{.type = vk::DescriptorType::eUniformTexelBuffer, .descriptorCount = bindings};
        impl_->pool = {device,
                       vk::DescriptorPoolCreateInfo{.flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                                    .maxSets = 1,
                                                    .poolSizeCount = 1,
                                                    .pPoolSizes = &size}};
        const vk::DescriptorSetLayout setLayout = *impl_->layout;
        vk::raii::DescriptorSets sets(device, vk::DescriptorSetAllocateInfo{.descriptorPool = *impl_->pool,
                                                                            .descriptorSetCount = 1,
                                                                            .pSetLayouts = &setLayout});
        impl_->set = std::move(sets.front());
    });
    for (std::uint32_t i = 0; i < bindings; ++i) {
        set(i, {}, TexelFormat::Float4); // a set must be valid as a whole
    }
}

TexelTables::~TexelTables() = default;
TexelTables::TexelTables(TexelTables&&) noexcept = default;
TexelTables& TexelTables::operator=(TexelTables&&) noexcept = default;

std::uint64_t TexelTables::shown(std::uint32_t binding) const {
    return impl_->addresses.at(binding);
}

void TexelTables::set(std::uint32_t binding, const Buffer& buffer, TexelFormat format) {
    vk::raii::BufferView& previous = impl_->views.at(binding);
    const Buffer::Impl& shown = buffer.impl() != nullptr ? *buffer.impl() : *impl_->dummy.impl();
    const std::size_t texels = (shown.bytes + kTexelBytes - 1) / kTexelBytes;
    const std::uint32_t limit = impl_->context->limits.maxTexelBufferElements;
    if (texels > limit) {
        throw Error(ExitCode::Device, '\'' + shown.name + "' has " + std::to_string(texels) + " texels, but " +
                                          impl_->context->info.name + " allows " + std::to_string(limit) +
                                          " in a table");
    }
    checked("showing buffer '" + shown.name + "' as a table", [&] {
        vk::raii::BufferView view(impl_->context->device,
                                  vk::BufferViewCreateInfo{.buffer = *shown.buffer,
                                                           .format = format == TexelFormat::Float4
                                                                         ? vk::Format::eR32G32B32A32Sfloat
                                                                         : vk::Format::eR32G32B32A32Uint,
                                                           .offset = 0,
                                                           .range = texels * kTexelBytes});
        const vk::BufferView handle = *view;
        impl_->context->device.updateDescriptorSets(
            vk::WriteDescriptorSet{.dstSet = *impl_->set,
                                   .dstBinding = binding,
                                   .descriptorCount = 1,
                                   .descriptorType = vk::DescriptorType::eUniformTexelBuffer,
                                   .pTexelBufferView = &handle},
            nullptr);
        impl_->formats[binding] = format;
        impl_->addresses[binding] = shown.address;
        previous = std::move(view); // the old view goes after the set has let go of it
    });
}

} // namespace hyalite::gpu
