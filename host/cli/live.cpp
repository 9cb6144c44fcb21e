// `hyalite live`: serves a page that shows a scene while it renders, and renders it again whenever a file is saved.
// Also the hidden command of the worker process that renders.
#include "base/error.h"
#include "base/numbers.h"
#include "base/private_folder.h"
#include "cli/command.h"
#include "cli/number_check.h"
#include "cli/open_device.h"
#include "cli/scene_settings.h"
#include "cli/shader_folder.h"
#include "gpu/context.h"
#include "live/server/live_server.h"
#include "live/worker/worker.h"
#include "scene/load/load_scene.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

namespace hyalite::cli {

namespace {

constexpr const char* kWorkerCommand = "live-worker";

struct LiveCommand {
    std::string scene;
    DeviceChoice device;
    std::string address = "127.0.0.1";
    std::optional<int> port;
    bool edit = false;
    double limit = 10; // [s]
    std::vector<std::string> settings;
    std::vector<std::string> twins; // files
};

std::vector<std::string> workerArguments(const DeviceChoice& device, const std::vector<std::string>& twins,
                                         const std::filesystem::path& cache) {
    std::vector<std::string> arguments{kWorkerCommand};
    const auto add = [&](const std::string& option, const std::string& value) {
        if (!value.empty()) {
            arguments.insert(arguments.end(), {option, value});
        }
    };
    add("--device", device.name);
    add("--shaders", device.shaders);
    add("--cache", cache.string());
    if (device.timeout) {
        add("--device-timeout", numberText(*device.timeout));
    }
    if (device.validation) {
        arguments.emplace_back("--validation");
    }
    for (const std::string& twin : twins) {
        add("--twins", std::filesystem::absolute(twin).string());
    }
    return arguments;
}

void runLive(LiveCommand command) {
    if (!std::filesystem::is_regular_file(command.scene)) {
        static_cast<void>(loadScene(command.scene)); // throws; the page shows other errors of the scene
    }
    static_cast<void>(gpu::chooseDevice(gpu::listDevices(), command.device.name)); // throws when there is none
    command.device.shaders = std::filesystem::absolute(findShaders(command.device.shaders)).lexically_normal().string();
    // A worker reuses what earlier workers compiled
    std::optional<PrivateFolder> ownCache;
    if (cacheFolder().empty()) {
        ownCache.emplace();
    }
    live::ServerOptions options;
    options.address = command.address;
    options.port = command.port.value_or(options.port);
    options.portIsAChoice = !command.port;
    options.mayWrite = command.edit;
    options.supervisor.scene = std::filesystem::absolute(command.scene).lexically_normal();
    options.supervisor.shaders = command.device.shaders;
    options.supervisor.workerArguments =
        workerArguments(command.device, command.twins, ownCache ? ownCache->path() : cacheFolder());
    options.supervisor.limit = command.limit;
    options.supervisor.say = [](const std::string& line) { std::cout << line << std::endl; };
    for (const std::string& setting : command.settings) {
        SettingAssignment given = parseAssignment(setting);
        options.supervisor.settings[given.key] = std::move(given.value);
    }
    live::serve(std::move(options));
}

} // namespace

void addLive(CLI::App& app) {
    const auto command = std::make_shared<LiveCommand>();
    CLI::App* sub =
        app.add_subcommand("live", "serve a page that shows a render; saving a shader or the scene renders it again");
    sub->add_option("SCENE", command->scene, "scene file (YAML)")->required();
    sub->add_option("--port", command->port, "port to listen on; 0: any free port (7878)")->check(CLI::Range(0, 65535));
    sub->add_option("--host", command->address,
                    "address to listen on, for access from other machines; the page then needs the printed token");
    sub->add_flag("--edit", command->edit, "let the page save shaders and the scene");
    sub->add_option("--limit", command->limit, "stop a kernel that takes longer than this many seconds (10)")
        ->check(finiteNumber(/*zeroAllowed*/ false));
    sub->add_option("--set", command->settings, "set a key of the scene file, e.g. --set camera.resolution=256x256");
    addTwinOption(*sub, command->twins);
    addDeviceOptions(*sub, command->device);
    sub->callback([command] { runLive(*command); });
}

void addLiveWorker(CLI::App& app) {
    struct WorkerCommand {
        DeviceChoice device;
        live::WorkerOptions options;
        std::vector<std::string> twins;
    };
    const auto command = std::make_shared<WorkerCommand>();
    CLI::App* sub = app.add_subcommand(kWorkerCommand, "started by hyalite live");
    sub->group(""); // not for users
    sub->add_option("--channel", command->options.channel)->required();
    sub->add_option("--pulse", command->options.pulse)->required();
    sub->add_option("--cache", command->options.cache)->required();
    addTwinOption(*sub, command->twins);
    addDeviceOptions(*sub, command->device);
    sub->callback([command] {
        const OpenDevice device(command->device);
        command->options.shaders = device.compiler().shaders();
        command->options.shipped = shippedKernels();
        command->options.twins = twinSources(command->twins);
        live::runWorker(device.context(), command->options);
    });
}

} // namespace hyalite::cli
