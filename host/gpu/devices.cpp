// What the machine has in Vulkan devices, what each lacks for our kernels, and which one is taken.
#include "gpu/context_impl.h"
#include "gpu/driver_hint.h"

#include <algorithm>
#include <cctype>

namespace hyalite::gpu {
namespace {

std::string versionText(std::uint32_t version) {
    std::string text = std::to_string(VK_API_VERSION_MAJOR(version));
    text += '.';
    return text += std::to_string(VK_API_VERSION_MINOR(version));
}

std::vector<std::string> missingFeatures(const vk::raii::PhysicalDevice& physical) {
    const auto features = physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features,
                                                vk::PhysicalDeviceVulkan13Features>();
    const auto& features12 = features.get<vk::PhysicalDeviceVulkan12Features>();
    const auto& features13 = features.get<vk::PhysicalDeviceVulkan13Features>();
    std::vector<std::string> missing;
    const auto require = [&missing](bool present, const char* name) {
        if (!present) {
            missing.emplace_back(name);
        }
    };
    require(features12.bufferDeviceAddress == VK_TRUE, "bufferDeviceAddress");
    require(features12.scalarBlockLayout == VK_TRUE, "scalarBlockLayout");
    require(features13.synchronization2 == VK_TRUE, "synchronization2");
    require(features13.maintenance4 == VK_TRUE, "maintenance4");
    for (const vk::Format format : {vk::Format::eR32G32B32A32Sfloat, vk::Format::eR32G32B32A32Uint}) {
        const vk::FormatFeatureFlags use = physical.getFormatProperties(format).bufferFeatures;
        require(bool(use & vk::FormatFeatureFlagBits::eUniformTexelBuffer), "uniform texel buffers of 4 x 32 bits");
    }
    const auto subgroup = physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceSubgroupProperties>()
                              .get<vk::PhysicalDeviceSubgroupProperties>();
    require(bool(subgroup.supportedStages & vk::ShaderStageFlagBits::eCompute) &&
                bool(subgroup.supportedOperations & vk::SubgroupFeatureFlagBits::eArithmetic),
            "sums over a subgroup");
    const auto families = physical.getQueueFamilyProperties();
    const auto computes = [](const vk::QueueFamilyProperties& family) {
        return bool(family.queueFlags & vk::QueueFlagBits::eCompute);
    };
    const auto family = std::find_if(families.begin(), families.end(), computes);
    require(family != families.end(), "a compute queue");
    require(family != families.end() && family->timestampValidBits > 0, "timestamps on its compute queue");
    return missing;
}

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

// "0: name, 1: name", for messages.
std::string listNames(const std::vector<DeviceInfo>& devices) {
    std::string text;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        text += i == 0 ? "" : ", ";
        text += std::to_string(i) + ": " + devices[i].name;
    }
    return text;
}

std::string listMissing(const DeviceInfo& device) {
    std::string text;
    for (const std::string& feature : device.missing) {
        text += text.empty() ? "" : ", ";
        text += feature;
    }
    return text;
}

// The device of that index, or the only one whose name has `wanted` in it, whatever the case of the letters.
std::size_t findDevice(const std::vector<DeviceInfo>& devices, const std::string& wanted) {
    const bool isIndex =
        std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    std::vector<std::size_t> matches;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const bool named = lowerCase(devices[i].name).find(lowerCase(wanted)) != std::string::npos;
        if (isIndex ? wanted == std::to_string(i) : named) {
            matches.push_back(i);
        }
    }
    if (matches.size() != 1) {
        throw Error(ExitCode::Device,
                    (matches.empty() ? "no Vulkan device '" : "several Vulkan devices match '") + wanted + '\'',
                    "there are " + listNames(devices));
    }
    return matches.front();
}

} // namespace

DeviceInfo describe(const vk::raii::PhysicalDevice& physical) {
    const vk::PhysicalDeviceProperties properties = physical.getProperties();
    DeviceInfo info;
    info.name = properties.deviceName.data();
    info.software = properties.deviceType == vk::PhysicalDeviceType::eCpu;
    if (properties.apiVersion < VK_API_VERSION_1_3) {
        // Its newer structs must not even be asked for.
        info.missing.push_back("Vulkan 1.3 (not " + versionText(properties.apiVersion) + ')');
        return info;
    }
    const auto chain = physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties,
                                               vk::PhysicalDeviceSubgroupProperties>();
    const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
    info.subgroupSize = chain.get<vk::PhysicalDeviceSubgroupProperties>().subgroupSize;
    info.driver = std::string(driver.driverName.data()) + ' ' + driver.driverInfo.data();
    info.missing = missingFeatures(physical);
    return info;
}

std::uint32_t computeQueueFamily(const vk::raii::PhysicalDevice& physical) {
    const auto families = physical.getQueueFamilyProperties();
    std::uint32_t family = 0;
    while (family < families.size() && !(families[family].queueFlags & vk::QueueFlagBits::eCompute)) {
        ++family;
    }
    return family;
}

std::unique_ptr<vk::raii::Context> openLoader() {
    try {
        return std::make_unique<vk::raii::Context>();
    } catch (const std::runtime_error&) {
        return nullptr; // its library is not installed
    }
}

std::vector<DeviceInfo> listDevices() {
    std::vector<DeviceInfo> devices;
    const std::unique_ptr<vk::raii::Context> loader = openLoader();
    if (!loader) {
        return devices;
    }
    try {
        const vk::ApplicationInfo application{.pApplicationName = "hyalite", .apiVersion = VK_API_VERSION_1_3};
        const vk::raii::Instance instance(*loader, vk::InstanceCreateInfo{.pApplicationInfo = &application});
        for (const vk::raii::PhysicalDevice& physical : vk::raii::PhysicalDevices(instance)) {
            devices.push_back(describe(physical));
        }
    } catch (const vk::IncompatibleDriverError&) {
        devices.clear(); // the loader has no driver to load
    } catch (const vk::SystemError& error) {
        throw Error(ExitCode::Device, std::string("listing the Vulkan devices: ") + error.what());
    }
    return devices;
}

std::size_t chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& wanted) {
    if (devices.empty()) {
        throw Error(ExitCode::Device, "no Vulkan driver found", kInstallDriverHint);
    }
    if (!wanted.empty()) {
        const std::size_t found = findDevice(devices, wanted);
        if (!devices[found].missing.empty()) {
            throw Error(ExitCode::Device, devices[found].name + " lacks " + listMissing(devices[found]),
                        kInstallDriverHint);
        }
        return found;
    }
    for (const bool software : {false, true}) {
        for (std::size_t i = 0; i < devices.size(); ++i) {
            if (devices[i].software == software && devices[i].missing.empty()) {
                return i;
            }
        }
    }
    throw Error(ExitCode::Device, "no usable Vulkan device: " + devices[0].name + " lacks " + listMissing(devices[0]),
                kInstallDriverHint);
}

} // namespace hyalite::gpu
