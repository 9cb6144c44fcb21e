// `hyalite doctor`: checks whether this machine can render and tells how to fix what is missing. Goes through all that
// a render needs before its first pixel: driver, device, shaders, and a dispatch with a known result.
#include "cli/command.h"
#include "cli/shader_folder.h"
#include "gpu/lavapipe.h"
#include "gpu/self_test.h"
#include "gpu/shader_compiler.h"
#include "live/server/live_server.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hyalite::cli {
namespace {

struct DoctorOptions {
    std::string device;
    std::string shaders;
    bool json = false;
};

struct Check {
    std::string name;
    bool passed = false;
    std::string detail;
    std::string fix; // what to do; empty: nothing
    bool needed = true;
};

struct Diagnosis {
    std::vector<gpu::DeviceInfo> devices;
    std::optional<std::size_t> chosen;
    std::vector<Check> checks;

    [[nodiscard]] bool usable() const {
        return std::ranges::all_of(checks, [](const Check& check) { return check.passed || !check.needed; });
    }
};

// The error's message without the hint that follows it in brackets.
std::string withoutHint(const Error& error) {
    std::string text = error.what();
    if (!error.hint().empty()) {
        text.resize(text.size() - error.hint().size() - 3);
    }
    return text;
}

// A check that passes with the text that `find` returns. If `find` throws Error, the check fails with its message and
// its hint is the fix.
template <class Find>
Check examine(const std::string& name, const Find& find) {
    try {
        return {.name = name, .passed = true, .detail = find(), .fix = {}};
    } catch (const Error& error) {
        return {.name = name, .detail = withoutHint(error), .fix = error.hint()};
    }
}

std::string openDevice(const DoctorOptions& options, Diagnosis& diagnosis, std::unique_ptr<gpu::Context>& context) {
    gpu::prepareLavapipe(cacheFolder()); // doctor sees it as render does
    diagnosis.devices = gpu::listDevices();
    diagnosis.chosen = gpu::chooseDevice(diagnosis.devices, options.device);
    gpu::ContextOptions wanted;
    wanted.device = std::to_string(*diagnosis.chosen);
    context = std::make_unique<gpu::Context>(wanted);
    return context->info().name + " has all features that the kernels need";
}

std::string compileAll(const gpu::ShaderCompiler& compiler) {
    std::size_t kernels = 0;
    for (const auto& entry : std::filesystem::directory_iterator(compiler.shaders() / "kernels")) {
        if (entry.path().extension() == ".comp") {
            static_cast<void>(compiler.compile(entry.path().stem().string()));
            ++kernels;
        }
    }
    return "all " + std::to_string(kernels) + " kernels in " + compiler.shaders().string() + " compile";
}

std::string testDevice(const gpu::Context& context, const gpu::ShaderCompiler& compiler) {
    gpu::selfTest(context, compiler);
    return "long loops, texel fetches and struct layouts give the expected results";
}

Check examineValidation() {
    if (gpu::validationLayerInstalled()) {
        return {.name = "validation", .passed = true, .detail = "the layer is installed", .fix = {}, .needed = false};
    }
    return {.name = "validation",
            .detail = "the layer is not installed; only the tests use it",
            .fix = "scripts/install-deps.sh test",
            .needed = false};
}

Check examineEditor() {
    if (live::hasEditor()) {
        return {.name = "editor",
                .passed = true,
                .detail = "hyalite live has CodeMirror built in",
                .fix = {},
                .needed = false};
    }
    return {.name = "editor",
            .detail = "hyalite live was built without CodeMirror: its editor is a plain text field",
            .fix = "scripts/install-deps.sh, then build again",
            .needed = false};
}

Diagnosis diagnose(const DoctorOptions& options) {
    Diagnosis diagnosis;
    std::vector<Check>& checks = diagnosis.checks;
    std::unique_ptr<gpu::Context> context;
    std::unique_ptr<gpu::ShaderCompiler> compiler;
    checks.push_back(examine("device", [&] { return openDevice(options, diagnosis, context); }));
    checks.push_back(examine("shaders", [&] {
        // Without the cache, so that they are compiled now.
        compiler = std::make_unique<gpu::ShaderCompiler>(findShaders(options.shaders));
        return compileAll(*compiler);
    }));
    if (checks[0].passed && checks[1].passed) {
        checks.push_back(examine("self-test", [&] { return testDevice(*context, *compiler); }));
    }
    checks.push_back(examineValidation());
    checks.push_back(examineEditor());
    return diagnosis;
}

void printJson(const Diagnosis& diagnosis) {
    nlohmann::ordered_json object;
    object["version"] = HYALITE_VERSION;
    object["usable"] = diagnosis.usable();
    object["devices"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < diagnosis.devices.size(); ++i) {
        const gpu::DeviceInfo& device = diagnosis.devices[i];
        object["devices"].push_back({{"index", i},
                                     {"name", device.name},
                                     {"driver", device.driver},
                                     {"software", device.software},
                                     {"missing", device.missing},
                                     {"chosen", diagnosis.chosen == i}});
    }
    object["checks"] = nlohmann::ordered_json::array();
    for (const Check& check : diagnosis.checks) {
        object["checks"].push_back({{"name", check.name},
                                    {"passed", check.passed},
                                    {"needed", check.needed},
                                    {"detail", check.detail},
                                    {"fix", check.fix}});
    }
    std::cout << object.dump(2) << '\n';
}

void printText(const Diagnosis& diagnosis) {
    for (std::size_t i = 0; i < diagnosis.devices.size(); ++i) {
        const gpu::DeviceInfo& device = diagnosis.devices[i];
        std::cout << (diagnosis.chosen == i ? "* " : "  ") << i << ": " << device.name << ", " << device.driver << '\n';
        for (const std::string& feature : device.missing) {
            std::cout << "     lacks " << feature << '\n';
        }
    }
    for (const Check& check : diagnosis.checks) {
        const char* verdict = check.passed ? "ok" : check.needed ? "FAILED" : "missing";
        std::cout << std::left << std::setw(12) << check.name << std::setw(9) << verdict << check.detail << '\n';
        if (!check.fix.empty()) {
            std::cout << std::setw(21) << "" << "to fix: " << check.fix << '\n';
        }
    }
    std::cout << (diagnosis.usable() ? "hyalite can render here" : "hyalite cannot render here") << '\n';
}

} // namespace

void addDoctor(CLI::App& app, ExitCode& exit) {
    // Shared with the callback, which outlives this function.
    const auto options = std::make_shared<DoctorOptions>();
    CLI::App* command = app.add_subcommand("doctor", "check whether this machine can render, and how to fix it");
    command->add_option("--device", options->device, "the device to check: part of its name, or its number")
        ->type_name("NAME|INDEX");
    command->add_option("--shaders", options->shaders, "the folder of shaders to check")->type_name("DIR");
    command->add_flag("--json", options->json, "print one JSON object");
    command->callback([options, &exit] {
        const Diagnosis diagnosis = diagnose(*options);
        if (options->json) {
            printJson(diagnosis);
        } else {
            printText(diagnosis);
        }
        if (!diagnosis.usable()) {
            exit = ExitCode::Device;
        }
    });
}

} // namespace hyalite::cli
