#include "cli/open_device.h"

#include "base/error.h"
#include "cli/number_check.h"
#include "cli/shader_folder.h"
#include "gpu/lavapipe.h"
#include "gpu/self_test.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string_view>

namespace hyalite::cli {

namespace {

gpu::ContextOptions optionsOf(const DeviceChoice& choice) {
    gpu::prepareLavapipe(cacheFolder());
    return {.device = choice.name, .validation = choice.validation, .onValidationMessage = {}};
}

} // namespace

void addDeviceOptions(CLI::App& sub, DeviceChoice& choice) {
    sub.add_option("--device", choice.name, "device to use: part of its name, or its number (see hyalite doctor)");
    sub.add_option("--shaders", choice.shaders, "folder of shaders to use instead of the installed ones");
    sub.add_option("--device-timeout", choice.timeout, "time limit of the device for each part of a pass [s] (1800)")
        ->check(finiteNumber(/*zeroAllowed*/ false));
    sub.add_flag("--validation", choice.validation, "check every Vulkan call with the validation layers");
}

void addTwinOption(CLI::App& sub, std::vector<std::string>& twins) {
    sub.add_option("--twins", twins, "shared objects with C++ twins of the scene's custom GLSL, for the reference")
        ->type_name("FILE.so");
}

OpenDevice::OpenDevice(const DeviceChoice& choice)
    : context_(optionsOf(choice)), compiler_(findShaders(choice.shaders), cacheFolder(), shippedKernels()) {
    // Waiting for a hung device, as destructors do, would hang too: end the program at once
    gpu::setWatchdog(context_,
                     {.limit = choice.timeout.value_or(gpu::Watchdog().limit), .onStuck = [](const std::string& what) {
                          std::cerr << "hyalite: " << what << '\n';
                          std::cerr.flush();
                          std::_Exit(static_cast<int>(ExitCode::Device));
                      }});
    gpu::selfTest(context_, compiler_);
}

void OpenDevice::checkValidation() const {
    if (context_.validationMessages() > 0) {
        throw Error(ExitCode::Device, std::to_string(context_.validationMessages()) + " validation messages");
    }
}

} // namespace hyalite::cli
