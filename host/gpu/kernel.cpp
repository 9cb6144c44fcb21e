// From a kernel's name to a compute pipeline.
#include "gpu/kernel_impl.h"

#include "gpu/buffer_impl.h"
#include "gpu/checked_kernels.h"
#include "shaders/shared/limits.h"

namespace hyalite::gpu {
namespace {

// `tables`: number of bindings.
void checkInterface(const Kernel::Impl& kernel, const Context::Impl& context, std::size_t tables,
                    const SourceLocation& source) {
    const KernelInterface& interface = kernel.interface;
    const std::string what = "kernel '" + kernel.name + "': ";
    if (interface.localSize != shared::kGroupSize) {
        throw Error(ExitCode::BadInput, source,
                    what + "its workgroup has " + std::to_string(interface.localSize) + " threads, not " +
                        std::to_string(shared::kGroupSize),
                    "include lib/thread.glsl");
    }
    if (interface.pushConstantBytes == 0) {
        throw Error(ExitCode::BadInput, source, what + "it has no arguments",
                    "declare its Arguments struct as a scalar push_constant block");
    }
    if (interface.pushConstantBytes > context.limits.maxPushConstantsSize) {
        throw Error(ExitCode::Device, source,
                    what + "its arguments take " + std::to_string(interface.pushConstantBytes) + " bytes, but " +
                        context.info.name + " allows " + std::to_string(context.limits.maxPushConstantsSize));
    }
    if (!interface.tables.empty() && interface.tables.rbegin()->first >= tables) {
        throw Error(ExitCode::BadInput, source,
                    what + "it reads table " + std::to_string(interface.tables.rbegin()->first) + " of " +
                        std::to_string(tables));
    }
}

// The values of the kernel's specialization constants, by id.
std::map<std::uint32_t, std::uint32_t> select(Specialization specialization, const KernelInterface& interface,
                                              std::uint32_t workers) {
    specialization["kWorkers"] = workers;
    std::map<std::uint32_t, std::uint32_t> values;
    for (const auto& [name, value] : specialization) {
        const auto constant = interface.specializationConstants.find(name);
        if (constant != interface.specializationConstants.end()) {
            values[constant->second] = value;
        }
    }
    return values;
}

vk::raii::Pipeline makePipeline(const vk::raii::Device& device, vk::PipelineLayout layout, const SpirV& spirv) {
    const vk::raii::ShaderModule module(
        device,
        vk::ShaderModuleCreateInfo{.codeSize = spirv.size() * sizeof(SpirV::value_type), .pCode = spirv.data()});
    const vk::PipelineShaderStageCreateInfo stage{
        .stage = vk::ShaderStageFlagBits::eCompute, .module = *module, .pName = "main"};
    return {device, nullptr,
            vk::ComputePipelineCreateInfo{
                .flags = vk::PipelineCreateFlagBits::eDispatchBase, .stage = stage, .layout = layout}};
}

std::shared_ptr<const Kernel::Impl> make(const Context::Impl& context, const TexelTables::Impl& tables,
                                         const KernelCompiler& compiler, const std::string& name,
                                         const Specialization& specialization) {
    auto kernel = std::make_shared<Kernel::Impl>();
    kernel->name = name;
    const SpirV spirv = compiler.compile(name);
    kernel->interface = reflect(spirv);
    if constexpr (kCheckedKernels) {
        kernel->sources = compiler.sourceFiles(name);
    }
    const std::filesystem::path source = compiler.shaders() / "kernels" / (name + ".comp");
    checkInterface(*kernel, context, tables.views.size(), {.file = source.string()});
    const SpirV specialized =
        compiler.specialized(name, spirv, select(specialization, kernel->interface, context.workers));
    checked("creating kernel '" + kernel->name + '\'', [&] {
        const vk::DescriptorSetLayout setLayout = *tables.layout;
        const vk::PushConstantRange range{.stageFlags = vk::ShaderStageFlagBits::eCompute,
                                          .size = (kernel->interface.pushConstantBytes + 3U) & ~3U};
        kernel->layout = {context.device, vk::PipelineLayoutCreateInfo{.setLayoutCount = 1,
                                                                       .pSetLayouts = &setLayout,
                                                                       .pushConstantRangeCount = 1,
                                                                       .pPushConstantRanges = &range}};
        kernel->pipeline = makePipeline(context.device, *kernel->layout, specialized);
        const auto handle = reinterpret_cast<std::uint64_t>(static_cast<VkPipeline>(*kernel->pipeline));
        context.nameObject(vk::ObjectType::ePipeline, handle, kernel->name);
    });
    return kernel;
}

} // namespace

Kernel::Kernel(const Context& context, const TexelTables& tables, const KernelCompiler& compiler,
               const std::string& name, const Specialization& specialization) {
    std::promise<Made> made;
    made.set_value(make(context.impl(), tables.impl(), compiler, name, specialization));
    impl_ = made.get_future().share();
}

Kernel Kernel::inBackground(const Context& context, const TexelTables& tables, const KernelCompiler& compiler,
                            std::string name, const Specialization& specialization) {
    return Kernel(std::async(std::launch::async, [&context = context.impl(), &tables = tables.impl(), &compiler,
                                                  name = std::move(name), specialization] {
                      return make(context, tables, compiler, name, specialization);
                  }).share());
}

const std::string& Kernel::name() const {
    return impl().name;
}

const KernelInterface& Kernel::interface() const {
    return impl().interface;
}

} // namespace hyalite::gpu
