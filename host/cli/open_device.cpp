#include "cli/open_device.h"

#include "base/error.h"
#include "cli/number_check.h"
#include "cli/shader_folder.h"
#include "gpu/self_test.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string_view>

namespace hyalite::cli {

namespace {

// Mesa names what it has compiled by the shader, not by the vector width that LP_NATIVE_VECTOR_WIDTH asks for (25.0.7):
// from a cache with code for two widths a kernel calls functions of the other, and crashes. So each width that is asked
// for gets a cache of its own. To be called while there is one thread, before the driver is loaded.
void separateDriverCaches() {
    // NOLINTBEGIN(concurrency-mt-unsafe): there is one thread
    const char* width = std::getenv("LP_NATIVE_VECTOR_WIDTH");
    if (width == nullptr) {
        return;
    }
    const char* given = std::getenv("MESA_SHADER_CACHE_DIR");
    std::filesystem::path folder = given != nullptr ? std::filesystem::path(given) : cacheFolder();
    const bool isNumber = std::string_view(width).find_first_not_of("0123456789") == std::string_view::npos;
    if (folder.empty() || !isNumber) {
        setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
        return;
    }
    folder /= std::string("driver-width-") + width;
    std::error_code ignored; // the driver does without
    std::filesystem::create_directories(folder, ignored);
    setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 1);
    // NOLINTEND(concurrency-mt-unsafe)
}

gpu::ContextOptions optionsOf(const DeviceChoice& choice) {
    separateDriverCaches();
    return {.device = choice.name, .validation = choice.validation, .onValidationMessage = {}};
}

} // namespace

void addDeviceOptions(CLI::App& sub, DeviceChoice& choice) {
    sub.add_option("--device", choice.name, "part of a device's name, or its number (see hyalite doctor)");
    sub.add_option("--shaders", choice.shaders, "folder of shaders to use instead of the installed ones");
    sub.add_option("--device-timeout", choice.timeout, "seconds that the device may take for part of a pass (1800)")
        ->check(finiteNumber(/*zeroAllowed*/ false));
    sub.add_flag("--validation", choice.validation, "check every Vulkan call with the validation layers");
}

OpenDevice::OpenDevice(const DeviceChoice& choice)
    : context_(optionsOf(choice)), compiler_(findShaders(choice.shaders), cacheFolder()) {
    // Whoever waits for a device that hangs, as destructors do, hangs too: the program ends here
    gpu::setWatchdog(context_, {.limit = choice.timeout, .onStuck = [](const std::string& what) {
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
