#include "cli/open_device.h"

#include "base/error.h"
#include "cli/shader_folder.h"
#include "gpu/lavapipe.h"
#include "gpu/self_test.h"

namespace hyalite::cli {

namespace {

gpu::ContextOptions optionsOf(const DeviceChoice& choice) {
    gpu::prepareLavapipe(cacheFolder());
    return {.device = choice.name, .validation = choice.validation, .onValidationMessage = {}};
}

} // namespace

void addDeviceOptions(CLI::App& sub, DeviceChoice& choice) {
    sub.add_option("--device", choice.name, "part of a device's name, or its number (see hyalite doctor)");
    sub.add_option("--shaders", choice.shaders, "folder of shaders to use instead of the installed ones");
    sub.add_flag("--validation", choice.validation, "check every Vulkan call with the validation layers");
}

OpenDevice::OpenDevice(const DeviceChoice& choice)
    : context_(optionsOf(choice)), compiler_(findShaders(choice.shaders), cacheFolder(), shippedKernels()) {
    gpu::selfTest(context_, compiler_);
}

void OpenDevice::checkValidation() const {
    if (context_.validationMessages() > 0) {
        throw Error(ExitCode::Device, std::to_string(context_.validationMessages()) + " validation messages");
    }
}

} // namespace hyalite::cli
