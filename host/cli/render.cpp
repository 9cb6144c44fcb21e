// `hyalite render`: a scene file to pictures, on the device or by the reference.
#include "reference/render.h"
#include "base/output_file.h"
#include "base/progress.h"
#include "base/stopwatch.h"
#include "cli/command.h"
#include "cli/number_check.h"
#include "cli/open_device.h"
#include "cli/render_report.h"
#include "cli/scene_settings.h"
#include "image/image_io.h"
#include "render/buffer_dump.h"
#include "render/device.h"
#include "scene/load_scene.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

namespace hyalite::cli {

namespace {

struct RenderCommand {
    std::string scene;
    std::vector<std::string> outputs;
    std::string backend = "vulkan";
    DeviceChoice device;
    double time = 0; // [s]; 0: no limit
    std::string savePhotons;
    std::string loadPhotons;
    std::vector<std::string> dumps; // STAGE:FIELD
    bool layers = false;
    bool profile = false;
    bool json = false;
    bool quiet = false;
    // Options that stand for a key of the scene file
    std::vector<SceneSetting> shorthands{{"--integrator", "render.integrator", {}},
                                         {"--resolution", "camera.resolution", {}},
                                         {"--passes", "render.passes", {}},
                                         {"--samples", "render.passes", {}},
                                         {"--photons", "render.photons", {}},
                                         {"--max-depth", "render.max_depth", {}},
                                         {"--seed", "render.seed", {}},
                                         {"--sampler", "render.sampler", {}},
                                         {"--target-error", "render.target_error", {}}};
    std::vector<std::string> settings; // key=value
};

// An option that would have no effect is a mistake, not a matter of taste.
void refuseDeviceOptions(const RenderCommand& command) {
    const auto refuse = [](bool given, const char* option) {
        if (given) {
            throw Error(ExitCode::WrongUsage, std::string("--backend reference has no use for ") + option);
        }
    };
    refuse(!command.device.name.empty(), "--device");
    refuse(!command.device.shaders.empty(), "--shaders");
    refuse(command.device.validation, "--validation");
    refuse(command.profile, "--profile");
    refuse(!command.savePhotons.empty(), "--save-photons");
    refuse(!command.loadPhotons.empty(), "--load-photons");
    refuse(!command.dumps.empty(), "--dump");
}

std::string name(Integrator integrator) {
    switch (integrator) {
    case Integrator::Whitted:
        return "whitted";
    case Integrator::Ppm:
        return "ppm";
    case Integrator::PhotonMap:
        return "photonmap";
    case Integrator::Path:
        return "path";
    }
    return {};
}

LayeredImage renderOnDevice(const RenderCommand& command, const Scene& scene, ProgressBar& bar, RenderReport& report) {
    const OpenDevice device(command.device);
    render::RenderOptions renderOptions;
    renderOptions.profile = command.profile;
    renderOptions.timeLimit = command.time;
    renderOptions.onPass = [&](const render::Progress& p) {
        bar.update({p.passes, p.ofPasses, p.seconds, command.time, p.errorEstimate});
    };
    renderOptions.savePhotons = command.savePhotons;
    renderOptions.loadPhotons = command.loadPhotons;
    std::vector<render::DumpRequest> requests;
    for (const std::string& dump : command.dumps) {
        requests.push_back(render::dumpRequest(dump));
        checkWritable(requests.back().file);
    }
    render::BufferDump dump(device.context(), std::move(requests));
    if (!command.dumps.empty()) {
        renderOptions.onUpload = [&](render::Device& renderer, const render::DeviceScene&) {
            renderer.commands.observe(&dump);
        };
    }
    render::RenderResult result = render::render(device.context(), device.compiler(), scene, renderOptions);
    report.device = device.context().info().name + ", " + device.context().info().driver;
    report.passes = result.passes;
    report.errorEstimate = result.errorEstimate;
    report.setupSeconds = result.setupSeconds;
    report.renderSeconds = result.renderSeconds;
    report.counts = result.counts;
    report.notes = std::move(result.notes);
    report.memory = std::move(result.memory);
    report.stages = std::move(result.stages);
    device.checkValidation();
    dump.checkComplete();
    return std::move(result.image);
}

LayeredImage renderByReference(const RenderCommand& command, const Scene& scene, ProgressBar& bar,
                               RenderReport& report) {
    const Stopwatch watch;
    report.device = "CPU, double precision";
    reference::RenderOptions options;
    options.afterPass = [&](std::uint32_t passes, std::optional<double> error) {
        const render::Progress progress{passes, scene.render.passes, watch.seconds(), error};
        bar.update({passes, scene.render.passes, progress.seconds, command.time, error});
        report.passes = passes;
        report.errorEstimate = error;
        report.renderSeconds = progress.seconds;
        return render::timeForAnotherPass(progress, command.time) &&
               !render::reachesTarget(progress, scene.render.targetError);
    };
    return reference::render(scene, options);
}

// What a file holds: the picture and, if asked, its layers; a PNG keeps the picture alone.
std::vector<Layer> layersOf(const LayeredImage& image, bool all) {
    std::vector<Layer> layers{{"", image.picture}};
    for (const NamedImage& layer : image.layers) {
        if (all) {
            layers.push_back({layer.name, layer.image});
        }
    }
    if (all && image.error) {
        layers.push_back({"error", *image.error});
    }
    return layers;
}

// Options that have no use with this integrator or these outputs.
void refuseUnused(const RenderCommand& command, const Scene& scene) {
    const bool photonMap = scene.render.integrator == Integrator::PhotonMap;
    if (!photonMap && !(command.savePhotons.empty() && command.loadPhotons.empty())) {
        throw Error(ExitCode::WrongUsage, "only integrator photonmap saves and loads photon maps",
                    "add --integrator photonmap");
    }
    const bool anyExr = std::ranges::any_of(
        command.outputs, [](const std::string& output) { return std::filesystem::path(output).extension() == ".exr"; });
    const bool hasLayers = photonMap || (command.backend == "vulkan" && scene.render.integrator == Integrator::Ppm);
    if (command.layers && !hasLayers && scene.render.passes == 1) {
        throw Error(ExitCode::WrongUsage,
                    "--layers has no use here: this picture is not a sum, and one pass has no error",
                    "photonmap has layers, and ppm on the device; the error needs two passes");
    }
    if (command.layers && !anyExr) {
        throw Error(ExitCode::WrongUsage, "--layers has no use without an .exr file to write them to",
                    "add -o FILE.exr");
    }
    if (!command.savePhotons.empty()) {
        checkWritable(command.savePhotons);
    }
}

void renderScene(RenderCommand command) {
    const Stopwatch watch;
    const bool byReference = command.backend == "reference";
    if (byReference) {
        refuseDeviceOptions(command);
    }
    Scene scene = loadScene(command.scene);
    applySettings(scene, allSettings(command.shorthands, command.settings));
    if (command.outputs.empty()) {
        command.outputs.push_back(std::filesystem::path(command.scene).stem().string() + ".png");
    }
    for (const std::string& output : command.outputs) {
        checkImageWritable(output);
    }
    refuseUnused(command, scene);

    RenderReport report;
    report.scene = command.scene;
    report.integrator = name(scene.render.integrator);
    report.backend = command.backend;
    report.seed = scene.render.seed;
    report.sampler = scene.render.sampler == RandomNumbers::Sobol ? "sobol" : "independent";
    report.targetError = scene.render.targetError;
    report.resolution = scene.camera.resolution;
    report.outputs = command.outputs;
    LayeredImage image;
    {
        ProgressBar bar(!command.quiet && !command.json);
        image =
            byReference ? renderByReference(command, scene, bar, report) : renderOnDevice(command, scene, bar, report);
    }
    for (const std::string& output : command.outputs) {
        writeImage(output, layersOf(image, command.layers),
                   {{"software", "hyalite " HYALITE_VERSION},
                    {"scene", std::filesystem::path(command.scene).filename().string()},
                    {"integrator", report.integrator},
                    {"backend", report.backend},
                    {"seed", std::to_string(report.seed)},
                    {"sampler", report.sampler},
                    {"passes", std::to_string(report.passes)}});
    }
    report.totalSeconds = watch.seconds();
    warnOfTarget(report);

    for (const std::string& warning : report.notes.warnings) {
        std::cerr << "hyalite: warning: " << warning << '\n';
    }
    if (command.json) {
        std::cout << jsonReport(report) << '\n';
        return;
    }
    if (command.profile) {
        std::cout << stageTable(report) << memoryTable(report) << photonTable(report);
    }
    if (!command.quiet) {
        for (const std::string& output : command.outputs) {
            std::cout << std::filesystem::absolute(output).lexically_normal().string() << ": " << report.resolution.x
                      << " x " << report.resolution.y << ", " << report.passes
                      << (report.passes == 1 ? " pass in " : " passes in ") << std::round(10 * report.totalSeconds) / 10
                      << " s" << errorText(report) << '\n';
        }
    }
}

} // namespace

void addRender(CLI::App& app, ExitCode&) {
    const auto command = std::make_shared<RenderCommand>();
    CLI::App* sub = app.add_subcommand("render", "render a scene to pictures");
    sub->add_option("SCENE", command->scene, "scene file (YAML)")->required();
    sub->add_option("-o,--output", command->outputs, "picture to write, .png or .exr; may be given several times");
    const auto shorthand = [&](std::size_t index, const std::string& text) {
        SceneSetting& setting = command->shorthands[index];
        sub->add_option(setting.option, setting.value, text);
    };
    shorthand(0, "ppm (progressive photon mapping), photonmap (in two passes), whitted (recursive ray tracing) or path "
                 "(path tracing, unbiased)");
    shorthand(1, "picture size, WIDTHxHEIGHT");
    shorthand(2, "passes, each one sample per pixel");
    shorthand(3, "the same as --passes");
    sub->get_option("--samples")->excludes("--passes");
    shorthand(4, "photons emitted per pass");
    shorthand(5, "longest path in segments; whitted: reflections and refractions in a row");
    shorthand(6, "seed of the random numbers");
    shorthand(8, "stop when the estimated error is no larger; --passes is then the most there may be");
    shorthand(7, "random numbers: sobol (evenly spread) or independent");
    sub->add_option("--backend", command->backend, "vulkan, or reference (CPU, double precision)")
        ->check(CLI::IsMember({"vulkan", "reference"}));
    addDeviceOptions(*sub, command->device);
    sub->add_option("--time", command->time, "stop when this many seconds of rendering would be exceeded")
        ->check(finiteNumber(/*zeroAllowed*/ false));
    sub->add_option("--set", command->settings, "set a key of the scene file, e.g. --set render.radius=0.01");
    sub->add_flag("--layers", command->layers,
                  "write the parts that the picture is the sum of, and its standard error, into .exr files too");
    sub->add_option("--save-photons", command->savePhotons, "photonmap: write the photon maps to this file");
    sub->add_option("--load-photons", command->loadPhotons,
                    "photonmap: read the photon maps from this file instead of tracing them");
    sub->add_option("--dump", command->dumps,
                    "write an array that a stage works on, after its first dispatch (or @N: number N), to "
                    "STAGE.FIELD.npy, e.g. trace_closest:hits.t")
        ->type_name("STAGE:FIELD[@N]");
    sub->add_flag("--profile", command->profile, "print tables of the stages' times and of the buffers' sizes");
    sub->add_flag("--json", command->json, "print one JSON object instead of text");
    sub->add_flag("--quiet", command->quiet, "print nothing but errors");
    sub->callback([command] { renderScene(*command); });
}

} // namespace hyalite::cli
