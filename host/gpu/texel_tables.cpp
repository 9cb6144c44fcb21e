// The descriptor set of uniform texel buffers that every kernel is bound with.
#include "gpu/buffer_impl.h"
#include "gpu/checked_kernels.h"

#include <algorithm>
#include <array>

namespace hyalite::gpu {
namespace {

// The buffer of the checks: texels for so many buffers, then the report (see shaders/lib/checked.glsl).
constexpr std::size_t kMostChecked = 4095;
constexpr std::size_t kReportAt = (kMostChecked + 1) * kTexelBytes;
constexpr std::size_t kReportBytes = 1024;

struct CheckReport {
    std::uint32_t outside = 0;
    std::uint32_t site = 0;
    std::uint32_t thread = 0;
    std::uint32_t index = 0;
    std::uint32_t length = 0;
};

} // namespace

void TexelTables::Impl::describeBuffers() const {
    std::vector<std::array<std::uint32_t, 4>> texels(1);
    for (const auto& [address, buffer] : context->buffers) { // in ascending order
        texels.push_back({std::uint32_t(address), std::uint32_t(address >> 32U),
                          std::uint32_t(std::min<std::size_t>(buffer.bytes, UINT32_MAX)), 0});
    }
    if (texels.size() > kMostChecked + 1) {
        throw Error(ExitCode::Device, "more buffers than the checked build knows");
    }
    const std::uint64_t report = checks.address() + kReportAt;
    texels[0] = {std::uint32_t(texels.size() - 1), std::uint32_t(report), std::uint32_t(report >> 32U), 0};
    std::memcpy(checks.mapped().data(), texels.data(), texels.size() * kTexelBytes);
    std::memset(checks.mapped().data() + kReportAt, 0, kReportBytes);
}

std::string TexelTables::Impl::indexOutside(const std::vector<std::string>& sources) const {
    CheckReport report;
    std::memcpy(&report, checks.mapped().data() + kReportAt, sizeof report);
    if (report.outside == 0) {
        return {};
    }
    const std::size_t file = report.site >> kSiteLineBits;
    return (file < sources.size() ? sources[file] : "?") + ':' +
           std::to_string(report.site & ((1U << kSiteLineBits) - 1)) + ": index " + std::to_string(report.index) +
           " of an array of " + std::to_string(report.length) + ", in thread " + std::to_string(report.thread) +
           " (the first of " + std::to_string(report.outside) + " such accesses)";
}

TexelTables::TexelTables(const Context& context, std::uint32_t bindings) : impl_(std::make_unique<Impl>()) {
    impl_->context = &context.impl();
    impl_->dummy = Buffer(context, kTexelBytes, "empty texel table", Memory::Host);
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
        if constexpr (kCheckedKernels) {
            layout.push_back({.binding = kCheckBinding,
                              .descriptorType = vk::DescriptorType::eUniformTexelBuffer,
                              .descriptorCount = 1,
                              .stageFlags = vk::ShaderStageFlagBits::eCompute});
        }
        const auto count = std::uint32_t(layout.size());
        impl_->layout = {device, vk::DescriptorSetLayoutCreateInfo{.bindingCount = count, .pBindings = layout.data()}};
        const vk::DescriptorPoolSize size{.type = vk::DescriptorType::eUniformTexelBuffer, .descriptorCount = count};
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
    if constexpr (kCheckedKernels) {
        impl_->checks = Buffer(context, kReportAt + kReportBytes, "lengths of buffers", Memory::Host);
        impl_->checksView = impl_->show(kCheckBinding, *impl_->checks.impl(), TexelFormat::Uint4);
        impl_->describeBuffers();
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
    vk::raii::BufferView view = impl_->show(binding, shown, format);
    impl_->formats[binding] = format;
    impl_->addresses[binding] = shown.address;
    previous = std::move(view); // the old view goes after the set has let go of it
}

vk::raii::BufferView TexelTables::Impl::show(std::uint32_t binding, const Buffer::Impl& shown,
                                             TexelFormat format) const {
    return checked("showing buffer '" + shown.name + "' as a table", [&] {
        vk::raii::BufferView view(
            context->device,
            vk::BufferViewCreateInfo{.buffer = *shown.buffer,
                                     .format = format == TexelFormat::Float4 ? vk::Format::eR32G32B32A32Sfloat
                                                                             : vk::Format::eR32G32B32A32Uint,
                                     .offset = 0,
                                     .range = (shown.bytes + kTexelBytes - 1) / kTexelBytes * kTexelBytes});
        const vk::BufferView handle = *view;
        context->device.updateDescriptorSets(
            vk::WriteDescriptorSet{.dstSet = *set,
                                   .dstBinding = binding,
                                   .descriptorCount = 1,
                                   .descriptorType = vk::DescriptorType::eUniformTexelBuffer,
                                   .pTexelBufferView = &handle},
            nullptr);
        return view;
    });
}

} // namespace hyalite::gpu
