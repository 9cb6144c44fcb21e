// A Vulkan layer that reports a lost device at a submission: an error that no software driver ever returns.
// HYALITE_LOSE_AT is the number of submissions of the process that succeed first.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdlib>
#include <cstring>

namespace {

// The next functions below this layer. A test process creates all its devices on one driver.
struct Below {
    PFN_vkGetInstanceProcAddr instance = nullptr;
    PFN_vkGetDeviceProcAddr device = nullptr;
    std::atomic<PFN_vkQueueSubmit2> submit = nullptr;
    std::atomic<long> submissions = 0;
};

Below& below() {
    static Below state;
    return state;
}

VKAPI_ATTR VkResult VKAPI_CALL submit(VkQueue queue, std::uint32_t count, const VkSubmitInfo2* infos, VkFence fence) {
    const char* const limit = std::getenv("HYALITE_LOSE_AT"); // NOLINT(concurrency-mt-unsafe): nobody sets it
    if (limit != nullptr && ++below().submissions > std::strtol(limit, nullptr, 10)) {
        return VK_ERROR_DEVICE_LOST;
    }
    return below().submit.load()(queue, count, infos, fence);
}

// The loader's link to the next layer, in the chain of a create info.
template <class Link, class Info>
Link* linkOf(const Info* info, VkStructureType type) {
    const auto* link = static_cast<const Link*>(info->pNext);
    while (link != nullptr && (link->sType != type || link->function != VK_LAYER_LINK_INFO)) {
        link = static_cast<const Link*>(link->pNext);
    }
    return const_cast<Link*>(link); // each layer advances it to the next one, as the loader's interface requires
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* memory,
                                              VkInstance* instance) {
    auto* link = linkOf<VkLayerInstanceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    if (link == nullptr) {
        return VK_ERROR_INITIALIZATION_FAILED;
    }
    below().instance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(below().instance(nullptr, "vkCreateInstance"));
    return create(info, memory, instance);
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* memory, VkDevice* device) {
    auto* link = linkOf<VkLayerDeviceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    if (link == nullptr) {
        return VK_ERROR_INITIALIZATION_FAILED;
    }
    const PFN_vkGetInstanceProcAddr next = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    below().device = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(next(nullptr, "vkCreateDevice"));
    const VkResult result = create(physical, info, memory, device);
    if (result == VK_SUCCESS) {
        below().submit = reinterpret_cast<PFN_vkQueueSubmit2>(below().device(*device, "vkQueueSubmit2"));
    }
    return result;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceFunction(VkDevice device, const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) {
        return reinterpret_cast<PFN_vkVoidFunction>(&deviceFunction);
    }
    if (std::strcmp(name, "vkQueueSubmit2") == 0 || std::strcmp(name, "vkQueueSubmit2KHR") == 0) {
        return reinterpret_cast<PFN_vkVoidFunction>(&submit);
    }
    return below().device(device, name); // NOLINT(clang-analyzer-core.CallAndMessage): set with the device
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instanceFunction(VkInstance instance, const char* name) {
    if (std::strcmp(name, "vkGetInstanceProcAddr") == 0) {
        return reinterpret_cast<PFN_vkVoidFunction>(&instanceFunction);
    }
    if (std::strcmp(name, "vkCreateInstance") == 0) {
        return reinterpret_cast<PFN_vkVoidFunction>(&createInstance);
    }
    if (std::strcmp(name, "vkCreateDevice") == 0) {
        return reinterpret_cast<PFN_vkVoidFunction>(&createDevice);
    }
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) {
        return reinterpret_cast<PFN_vkVoidFunction>(&deviceFunction);
    }
    return below().instance(instance, name); // NOLINT(clang-analyzer-core.CallAndMessage): set with the instance
}

} // namespace

extern "C" __attribute__((visibility("default"))) VkResult
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface) {
    interface->loaderLayerInterfaceVersion = 2;
    interface->pfnGetInstanceProcAddr = &instanceFunction;
    interface->pfnGetDeviceProcAddr = &deviceFunction;
    interface->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
