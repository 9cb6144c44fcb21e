// `hyalite parity`: does the device compute what the reference computes, and if not, where do they part?
#include "parity/parity.h"
#include "cli/command.h"
#include "cli/parity_report.h"
#include "cli/scene_settings.h"
#include "cli/shader_folder.h"
#include "gpu/self_test.h"
#include "scene/load_scene.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

namespace hyalite::cli {

namespace {

struct ParityCommand {
    std::string scene;
    std::string device;
    std::string shaders;
    std::vector<std::string> stages;
    bool asItIs = false;
    bool json = false;
    std::vector<SceneSetting> shorthands{
        {"--integrator", "render.integrator", {}}, {"--resolution", "camera.resolution", {}},
        {"--passes", "render.passes", {}},         {"--photons", "render.photons", {}},
        {"--max-depth", "render.max_depth", {}},   {"--seed", "render.seed", {}}};
    std::vector<std::string> settings;
};

Scene loadTestScene(const ParityCommand& command) {
    Scene scene = loadScene(command.scene);
    if (!command.asItIs) {
        parity::shrinkToTestSize(scene);
    }
    applySettings(scene, allSettings(command.shorthands, command.settings));
    return scene;
}

void runParity(const ParityCommand& command, ExitCode& exit) {
    const Scene scene = loadTestScene(command);
    gpu::ContextOptions options;
    options.device = command.device;
    const gpu::Context context(options);
    const gpu::ShaderCompiler compiler(findShaders(command.shaders), cacheFolder());
    gpu::selfTest(context, compiler);
    const parity::Result result =
        parity::compareSides(context, compiler, scene, {.stages = {command.stages.begin(), command.stages.end()}});
    const std::string device = context.info().name + ", " + context.info().driver;
    if (command.json) {
        std::cout << parityJson(result, command.scene, device) << '\n';
    } else {
        std::cout << parityTable(result) << parityVerdict(result) << '\n';
    }
    if (!result.passed()) {
        exit = ExitCode::ComparisonFailed;
    }
}

} // namespace

void addParity(CLI::App& app, ExitCode& exit) {
    const auto command = std::make_shared<ParityCommand>();
    CLI::App* sub =
        app.add_subcommand("parity", "compare every stage on the device with the double-precision reference");
    sub->add_option("SCENE", command->scene, "scene file (YAML)")->required();
    sub->add_option("--stages", command->stages, "compare these kernels alone, e.g. trace_closest,shade_surface")
        ->delimiter(',');
    const auto shorthand = [&](std::size_t index, const std::string& text) {
        SceneSetting& setting = command->shorthands[index];
        sub->add_option(setting.option, setting.value, text);
    };
    shorthand(0, "ppm, photonmap, whitted or path");
    shorthand(1, "picture size, WIDTHxHEIGHT; default: the scene's, at most 64 a side");
    shorthand(2, "passes; default: the scene's, at most 2");
    shorthand(3, "photons emitted per pass; default: the scene's, at most 8192");
    shorthand(4, "longest path in segments; whitted: reflections and refractions in a row");
    shorthand(5, "seed of the random numbers");
    sub->add_option("--set", command->settings, "set a key of the scene file, e.g. --set render.radius=0.01");
    sub->add_flag("--full", command->asItIs, "compare at the scene's own size, however long that takes");
    sub->add_option("--device", command->device, "part of a device's name, or its number (see hyalite doctor)");
    sub->add_option("--shaders", command->shaders, "folder of shaders to use instead of the installed ones");
    sub->add_flag("--json", command->json, "print one JSON object instead of text");
    sub->callback([command, &exit] { runParity(*command, exit); });
}

} // namespace hyalite::cli
