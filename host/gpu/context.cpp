// Makes the instance, the device and its queue, and listens to the validation layer.
#include "gpu/context_impl.h"

#include "gpu/buffer_impl.h"
#include "gpu/checked_kernels.h"
#include "gpu/driver_hint.h"
#include "gpu/lavapipe.h"
#include "gpu/staging.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iostream>

namespace hyalite::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

// Warnings and errors of the layers; the loader's own chatter ("general") says nothing about our calls.
vk::DebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationLog& log) {
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
    return {.messageSeverity = Severity::eWarning | Severity::eError,
            .messageType = Type::eValidation | Type::ePerformance,
            // Generic, since the headers changed the parameter types from C's to C++'s.
            .pfnUserCallback = [](auto /*severity*/, auto /*types*/, const auto* data, void* user) -> vk::Bool32 {
                auto& sink = *static_cast<ValidationLog*>(user);
                ++sink.messages;
                sink.handler(data->pMessage);
                return VK_FALSE; // let the call go on as it would without the layer
            },
            .pUserData = &log};
}

bool hasValidationLayer(const vk::raii::Context& loader) {
    const auto layers = loader.enumerateInstanceLayerProperties();
    return std::any_of(layers.begin(), layers.end(), [](const vk::LayerProperties& layer) {
        return std::strcmp(layer.layerName, kValidationLayer) == 0;
    });
}

vk::raii::Instance makeInstance(const vk::raii::Context& loader, ValidationLog& log, bool validation) {
    const vk::ApplicationInfo application{.pApplicationName = "hyalite", .apiVersion = VK_API_VERSION_1_3};
    if (!validation) {
        return {loader, vk::InstanceCreateInfo{.pApplicationInfo = &application}};
    }
    if (!hasValidationLayer(loader)) {
        throw Error(ExitCode::Device, std::string("the validation layer ") + kValidationLayer + " is not installed",
                    "apt-get install vulkan-validationlayers");
    }
    const std::array layers{kValidationLayer};
    const std::array extensions{VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    const vk::ValidationFeatureEnableEXT synchronization = vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
    // Heard from the first call on, before there is a messenger.
    const vk::DebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(log);
    const vk::ValidationFeaturesEXT features{
        .pNext = &messenger, .enabledValidationFeatureCount = 1, .pEnabledValidationFeatures = &synchronization};
    return {loader, vk::InstanceCreateInfo{.pNext = &features,
                                           .pApplicationInfo = &application,
                                           .enabledLayerCount = std::uint32_t(layers.size()),
                                           .ppEnabledLayerNames = layers.data(),
                                           .enabledExtensionCount = std::uint32_t(extensions.size()),
                                           .ppEnabledExtensionNames = extensions.data()}};
}

vk::raii::Device makeDevice(const Context::Impl& impl) {
    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue{
        .queueFamilyIndex = impl.queueFamily, .queueCount = 1, .pQueuePriorities = &priority};
    vk::PhysicalDeviceVulkan13Features features13{.synchronization2 = VK_TRUE, .maintenance4 = VK_TRUE};
    const vk::PhysicalDeviceVulkan12Features features12{
        .pNext = &features13, .scalarBlockLayout = VK_TRUE, .bufferDeviceAddress = VK_TRUE};
    const std::array extensions{VK_EXT_MEMORY_BUDGET_EXTENSION_NAME};
    // Checked kernels compute with addresses
    const vk::PhysicalDeviceFeatures features{.shaderInt64 = kCheckedKernels ? VK_TRUE : VK_FALSE};
    return {impl.physical, vk::DeviceCreateInfo{.pNext = &features12,
                                                .queueCreateInfoCount = 1,
                                                .pQueueCreateInfos = &queue,
                                                .enabledExtensionCount = impl.memoryBudget ? 1U : 0U,
                                                .ppEnabledExtensionNames = extensions.data(),
                                                .pEnabledFeatures = &features}};
}

void readLimits(Context::Impl& impl) {
    const auto chain = impl.physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceVulkan11Properties,
                                                    vk::PhysicalDeviceVulkan13Properties>();
    impl.limits = chain.get<vk::PhysicalDeviceProperties2>().properties.limits;
    impl.maxAllocation = std::min(chain.get<vk::PhysicalDeviceVulkan11Properties>().maxMemoryAllocationSize,
                                  chain.get<vk::PhysicalDeviceVulkan13Properties>().maxBufferSize);
    const std::uint32_t bits = impl.physical.getQueueFamilyProperties()[impl.queueFamily].timestampValidBits;
    impl.timestampMask = bits >= 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << bits) - 1;
    impl.secondsPerTick = 1e-9 * double(impl.limits.timestampPeriod);
    const auto extensions = impl.physical.enumerateDeviceExtensionProperties();
    impl.memoryBudget = std::any_of(extensions.begin(), extensions.end(), [](const vk::ExtensionProperties& extension) {
        return std::strcmp(extension.extensionName, VK_EXT_MEMORY_BUDGET_EXTENSION_NAME) == 0;
    });
}

void open(Context::Impl& impl, const ContextOptions& options) {
    impl.loader = openLoader();
    if (!impl.loader) {
        throw Error(ExitCode::Device, "no Vulkan loader found (libvulkan.so.1)", kInstallDriverHint);
    }
    try {
        impl.instance = makeInstance(*impl.loader, impl.log, options.validation);
    } catch (const vk::IncompatibleDriverError&) {
        throw Error(ExitCode::Device, "no Vulkan driver found", kInstallDriverHint);
    }
    if (options.validation) {
        impl.messenger = impl.instance.createDebugUtilsMessengerEXT(messengerInfo(impl.log));
    }
    vk::raii::PhysicalDevices physicals(impl.instance);
    std::vector<DeviceInfo> devices;
    std::transform(physicals.begin(), physicals.end(), std::back_inserter(devices), describe);
    const std::size_t chosen = chooseDevice(devices, options.device);
    impl.info = devices[chosen];
    impl.physical = std::move(physicals[chosen]);
    impl.queueFamily = computeQueueFamily(impl.physical);
    impl.workers = impl.info.software ? lavapipeThreads() : 1;
    readLimits(impl);
    impl.device = makeDevice(impl);
    impl.queue = impl.device.getQueue(impl.queueFamily, 0);
    impl.staged = options.staged;
    impl.staging = std::make_unique<Staging>(impl);
}

} // namespace

bool validationLayerInstalled() {
    const std::unique_ptr<vk::raii::Context> loader = openLoader();
    return loader && hasValidationLayer(*loader);
}

Context::Context(const ContextOptions& options) : impl_(std::make_unique<Impl>()) {
    impl_->log.handler = options.onValidationMessage ? options.onValidationMessage
                                                     : [](const std::string& text) { std::cerr << text << '\n'; };
    checked("opening the Vulkan device", [&] { open(*impl_, options); });
}

Context::~Context() = default;
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;

const DeviceInfo& Context::info() const {
    return impl_->info;
}

std::span<std::byte> Context::memoryAt(std::uint64_t address) const {
    auto after = impl_->buffers.upper_bound(address);
    if (after == impl_->buffers.begin()) {
        return {};
    }
    auto& [begin, listed] = *--after;
    if (address - begin >= listed.bytes) {
        return {};
    }
    std::span<std::byte> memory(listed.buffer->mapped, listed.bytes);
    if (listed.buffer->mapped == nullptr) {
        listed.copy.resize(listed.bytes);
        memory = listed.copy;
        impl_->staging->read(*listed.buffer, address - begin, memory.subspan(address - begin));
    }
    return memory.subspan(address - begin);
}

std::map<std::string, std::size_t> Context::memory() const {
    std::map<std::string, std::size_t> bytes;
    for (const auto& [address, buffer] : impl_->buffers) {
        bytes[buffer.name] += buffer.bytes;
    }
    return bytes;
}

std::uint32_t Context::validationMessages() const {
    return impl_->log.messages;
}

void Context::Impl::nameObject(vk::ObjectType type, std::uint64_t handle, const std::string& name) const {
    if (*messenger) {
        device.setDebugUtilsObjectNameEXT(
            vk::DebugUtilsObjectNameInfoEXT{.objectType = type, .objectHandle = handle, .pObjectName = name.c_str()});
    }
}

} // namespace hyalite::gpu
