// `hyalite parity`: compares every stage on the device with the reference and finds where they first differ. `hyalite
// inspect`: shows one path on both sides.
#include "parity/parity.h"
#include "base/output_file.h"
#include "cli/command.h"
#include "cli/machine.h"
#include "cli/open_device.h"
#include "cli/parity_report.h"
#include "cli/scene_settings.h"
#include "cli/shader_folder.h"
#include "cli/strict.h"
#include "parity/report.h"
#include "scene/load/load_scene.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>

namespace hyalite::cli {

namespace {

// The options of both commands.
struct Sought {
    std::string scene;
    DeviceChoice device;
    bool fullSize = false;
    bool testSize = false;
    bool strict = false;
    SettingOptions settings{"--target-error"}; // every pass is compared
    std::vector<std::string> twins;            // files
};

struct ParityCommand : Sought {
    std::vector<std::string> stages;
    std::string report; // folder; empty: none
    bool json = false;
};

struct InspectCommand : Sought {
    std::optional<std::array<std::uint32_t, 2>> pixel;
    std::optional<std::uint32_t> photon;
    bool caustic = false;
    std::uint32_t pass = 0;
};

void addSought(CLI::App& sub, Sought& sought) {
    sub.add_option("SCENE", sought.scene, "scene file (YAML)")->required();
    sought.settings.addTo(sub);
    addTwinOption(sub, sought.twins);
    addDeviceOptions(sub, sought.device);
    addStrictOption(sub, sought.strict);
}

Scene loadSought(const Sought& sought, bool atTestSize) {
    Scene scene = loadScene(sought.scene);
    reference::attachTwins(scene, twinSources(sought.twins));
    if (atTestSize) {
        parity::shrinkToTestSize(scene);
    }
    applySettings(scene, sought.settings.given());
    return scene;
}

// The command that repeats this comparison.
std::string commandLine(const ParityCommand& command) {
    std::string line = "hyalite parity " + command.scene;
    for (const SceneSetting& setting : command.settings.shorthands) {
        line += setting.value ? ' ' + setting.option + ' ' + *setting.value : "";
    }
    for (const std::string& setting : command.settings.assignments) {
        line += " --set " + setting;
    }
    for (const std::string& twin : command.twins) {
        line += " --twins " + twin;
    }
    line += command.device.name.empty() ? "" : " --device " + command.device.name;
    line += command.device.shaders.empty() ? "" : " --shaders " + command.device.shaders;
    return line + (command.fullSize ? " --full" : "");
}

// Reports a requested kernel that did not run and so was not compared.
void refuseAbsentStages(const std::vector<std::string>& wanted, const parity::Result& result) {
    for (const std::string& stage : wanted) {
        if (std::ranges::find(result.stages, stage, &parity::StageResult::name) == result.stages.end()) {
            throw Error(ExitCode::WrongUsage, "no kernel named '" + stage + "' runs in this render",
                        "hyalite parity without --stages lists the kernels that run");
        }
    }
}

void runParity(const ParityCommand& command, ExitCode& exit) {
    const Scene scene = loadSought(command, !command.fullSize);
    const std::vector<std::string> warnings = textsOf(warningsOf(scene));
    printWarnings(warnings, command.strict);
    const std::filesystem::path page = std::filesystem::path(command.report) / "parity.html";
    if (!command.report.empty()) {
        std::error_code ignored; // checkWritable reports the error
        std::filesystem::create_directories(command.report, ignored);
        checkWritable(page);
    }
    const OpenDevice device(command.device);
    const parity::Result result = parity::compareSides(device.context(), device.compiler(), scene,
                                                       {.stages = {command.stages.begin(), command.stages.end()}});
    refuseAbsentStages(command.stages, result);
    device.checkValidation();
    const parity::Circumstances circumstances{command.scene, commandLine(command), describeMachine(device.context()),
                                              warnings};
    if (!command.report.empty()) {
        const std::string html = parity::toHtml(result, scene, circumstances);
        writeFileAtomically(page, std::as_bytes(std::span(html)));
    }
    if (command.json) {
        std::cout << parity::toJson(result, circumstances) << '\n';
    } else {
        std::cout << parityTable(result, scene) << parity::verdict(result) << '\n';
        if (!command.report.empty()) {
            std::cout << std::filesystem::absolute(page).lexically_normal().string() << '\n';
        }
    }
    if (!result.passed()) {
        exit = ExitCode::ComparisonFailed;
    }
}

void runInspect(const InspectCommand& command) {
    if (command.pixel.has_value() == command.photon.has_value()) {
        throw Error(ExitCode::WrongUsage, "inspect needs either a pixel or a photon", "give --pixel X,Y or --photon N");
    }
    const Scene scene = loadSought(command, command.testSize);
    printWarnings(warningsOf(scene), command.strict);
    std::optional<std::uint32_t> pixel;
    if (command.pixel) {
        const glm::uvec2& resolution = scene.camera.resolution;
        const auto& [x, y] = *command.pixel;
        if (x >= resolution.x || y >= resolution.y) {
            throw Error(ExitCode::WrongUsage, "pixel " + std::to_string(x) + ',' + std::to_string(y) +
                                                  " is outside the picture of " + std::to_string(resolution.x) + " x " +
                                                  std::to_string(resolution.y));
        }
        pixel = y * resolution.x + x;
    }
    const OpenDevice device(command.device);
    const parity::RecordedPath path =
        pixel ? parity::inspectPixel(device.context(), device.compiler(), scene, command.pass, *pixel)
              : parity::inspectPhoton(device.context(), device.compiler(), scene, command.pass,
                                      {.number = *command.photon, .isCaustic = command.caustic});
    device.checkValidation();
    std::cout << pathTable(path, scene);
}

} // namespace

void addParity(CLI::App& app, ExitCode& exit) {
    const auto command = std::make_shared<ParityCommand>();
    CLI::App* sub =
        app.add_subcommand("parity", "compare every stage on the device with the double-precision reference");
    sub->footer("Without --full: at most 64 pixels a side, 2 passes and 8192 photons, unless --resolution, --passes or "
                "--photons are given.");
    addSought(*sub, *command);
    sub->add_option("--stages", command->stages, "compare only these kernels, e.g. trace_closest,shade_surface")
        ->delimiter(',');
    sub->add_option("--report", command->report, "write the report parity.html into this folder")->type_name("DIR");
    sub->add_flag("--full", command->fullSize, "compare at the scene's full size, which may take long");
    sub->add_flag("--json", command->json, "print one JSON object instead of text");
    sub->callback([command, &exit] { runParity(*command, exit); });
}

void addInspect(CLI::App& app) {
    const auto command = std::make_shared<InspectCommand>();
    CLI::App* sub = app.add_subcommand("inspect", "show the path of a pixel or a photon on both sides");
    addSought(*sub, *command);
    sub->add_option("--pixel", command->pixel, "pixel coordinates, from the upper left")
        ->delimiter(',')
        ->type_name("X,Y");
    sub->add_option("--photon", command->photon, "number of the photon in the pass")->type_name("N");
    sub->add_flag("--caustic", command->caustic, "the photon is a caustic photon, aimed at mirrors and glass")
        ->needs("--photon");
    sub->add_option("--pass", command->pass, "number of the pass, from 0")->type_name("N");
    sub->add_flag("--test-size", command->testSize, "use the reduced size of hyalite parity");
    sub->callback([command] { runInspect(*command); });
}

} // namespace hyalite::cli
