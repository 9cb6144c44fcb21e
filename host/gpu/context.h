// The Vulkan device that kernels run on. Only this folder's .cpp files include Vulkan's headers.
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
    bool software = false;            // a software driver on the CPU
    std::uint32_t subgroupSize = 0;   // lanes that run together; on a CPU, floats per vector
    std::vector<std::string> missing; // missing features and limits; empty: usable
};

struct ContextOptions {
    std::string device;      // part of a device's name, or its index; empty: the first usable one, GPUs before software
    bool validation = false; // core and synchronization validation
    bool staged = false;     // for tests: pretend that only Memory::Host is host-visible
    std::function<void(const std::string&)> onValidationMessage; // each message; default: stderr
};

// Every Vulkan device on the machine, in the loader's order. Empty if there is no driver; never throws for that.
[[nodiscard]] std::vector<DeviceInfo> listDevices();

// Is the validation layer installed (ContextOptions::validation)?
[[nodiscard]] bool validationLayerInstalled();

// The index in `devices` that a Context with this ContextOptions::device takes. Throws Error(Device) if none or several
// match, or the match lacks a required feature.
[[nodiscard]] std::size_t chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& wanted);

// Instance, device and its one compute queue. Throws Error(Device) if no device is usable, if `device` matches none or
// several, and if validation is requested and its layer is not installed. It must outlive everything created from it.
// selfTest() (self_test.h) checks that the driver computes correct results.
class Context {
public:
    explicit Context(const ContextOptions& options = {});
    ~Context();
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;

    [[nodiscard]] const DeviceInfo& info() const;
    [[nodiscard]] std::uint32_t validationMessages() const; // number received so far

    // The memory from a device address to the end of its buffer; empty if there is no buffer. If the host cannot see
    // that memory it is a copy, which the next call for the same buffer refreshes. No dispatch may be in flight.
    [[nodiscard]] std::span<std::byte> memoryAt(std::uint64_t address) const;

    // Bytes of the existing buffers, by name: several may share a name.
    [[nodiscard]] std::map<std::string, std::size_t> memory() const;

    struct Impl; // host/gpu only
    [[nodiscard]] Impl& impl() const { return *impl_; }

private:
    std::unique_ptr<Impl> impl_;
};

} // namespace hyalite::gpu
