// The Vulkan device that kernels run on. Vulkan's own headers are seen only in this folder's .cpp files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace hyalite::gpu {

struct DeviceInfo {
    std::string name;
    std::string driver;               // e.g. "llvmpipe Mesa 25.0.7-2 (LLVM 15.0.6)"
    bool software = false;            // runs on the CPU
    std::uint32_t subgroupSize = 0;   // lanes that run together; on a CPU, floats of a vector
    std::vector<std::string> missing; // features and limits it lacks; empty: usable
};

struct ContextOptions {
    std::string device;      // part of a device's name, or its index; empty: the first usable one, GPUs before software
    bool validation = false; // core and synchronization validation
    bool staged = false;     // for tests: as if the host saw no memory but that of Memory::Host
    std::function<void(const std::string&)> onValidationMessage; // each message; default: stderr
};

// Every Vulkan device on the machine, in the loader's order. Empty when there is no driver; never throws for that.
[[nodiscard]] std::vector<DeviceInfo> listDevices();

// Whether ContextOptions::validation can be asked for.
[[nodiscard]] bool validationLayerInstalled();

// Which of `devices` a Context with this ContextOptions::device takes. Throws Error(Device) when that is none, several,
// or one that lacks something.
[[nodiscard]] std::size_t chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& wanted);

// Instance, device and its one compute queue. Throws Error(Device) when nothing usable is there, when `device` names
// none or several, and when validation is asked for and its layer is not installed. It must outlive all that is made
// from it. Whether the driver computes what it should is for selfTest() (self_test.h) to say.
class Context {
public:
    explicit Context(const ContextOptions& options = {});
    ~Context();
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;

    [[nodiscard]] const DeviceInfo& info() const;
    [[nodiscard]] std::uint32_t validationMessages() const; // how many came so far

    // From a device address to the end of the buffer it lies in; empty where there is no buffer. Where the host does
    // not see that memory it is a copy, which the next call for the same buffer renews. No dispatch may be in flight.
    [[nodiscard]] std::span<std::byte> memoryAt(std::uint64_t address) const;

    // Bytes of the buffers that exist, by name: several may share one.
    [[nodiscard]] std::map<std::string, std::size_t> memory() const;

    struct Impl; // host/gpu only
    [[nodiscard]] Impl& impl() const { return *impl_; }

private:
    std::unique_ptr<Impl> impl_;
};

} // namespace hyalite::gpu
