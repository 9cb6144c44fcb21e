// The device that a command uses, selected by its options.
#pragma once

#include "gpu/context.h"
#include "gpu/shader_compiler.h"
#include "gpu/watchdog.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hyalite::cli {

struct DeviceChoice {
    std::string name;    // see gpu::ContextOptions
    std::string shaders; // folder; empty: the installed one
    bool validation = false;
    std::optional<double> timeout; // [s]; nullopt: the default of gpu::Watchdog
};

// Adds --device, --shaders, --validation and --device-timeout.
void addDeviceOptions(CLI::App& sub, DeviceChoice& choice);

// Adds --twins.
void addTwinOption(CLI::App& sub, std::vector<std::string>& twins);

class OpenDevice {
public:
    // Throws what gpu::Context, findShaders and gpu::selfTest throw.
    explicit OpenDevice(const DeviceChoice& choice);

    [[nodiscard]] const gpu::Context& context() const { return context_; }
    [[nodiscard]] const gpu::ShaderCompiler& compiler() const { return compiler_; }

    // Throws Error(Device) if the validation layers reported anything.
    void checkValidation() const;

private:
    gpu::Context context_;
    gpu::ShaderCompiler compiler_;
};

} // namespace hyalite::cli
