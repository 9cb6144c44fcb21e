// `hyalite render`: renders a scene file to pictures, on the device or with the reference.
#include "base/interrupt.h"
#include "base/numbers.h"
#include "base/output_file.h"
#include "base/progress.h"
#include "base/stopwatch.h"
#include "cli/command.h"
#include "cli/number_check.h"
#include "cli/open_device.h"
#include "cli/render_report.h"
#include "cli/scene_settings.h"
#include "cli/shader_folder.h"
#include "cli/strict.h"
#include "image/image_io.h"
#include "render/debug/buffer_dump.h"
#include "render/integrators/registry.h"
#include "render/picture_check.h"
#include "render/renderer.h"
#include "render/wavefront/device.h"
#include "scene/load/load_scene.h"
#include "scene/yaml/settings_table.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <iterator>
#include <limits>
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
    std::string checkpoint;
    bool resume = false;
    double checkpointEvery = render::CheckpointOptions().every; // [s]
    std::string savePhotons;
    std::string loadPhotons;
    std::vector<std::string> dumps; // STAGE:FIELD
    std::vector<std::string> twins; // files
    bool layers = false;
    bool profile = false;
    bool json = false;
    bool quiet = false;
    bool strict = false;
    std::uint32_t firstPass = 0; // of --passes FIRST:END
    SettingOptions settings;

    RenderCommand() { settings.shorthands.push_back({"--samples", "render.passes"}); }
};

// Rejects options that would have no effect.
void refuseDeviceOptions(const RenderCommand& command) {
    const auto refuse = [](bool given, const char* option) {
        if (given) {
            throw Error(ExitCode::WrongUsage, std::string("--backend reference does not support ") + option);
        }
    };
    refuse(!command.device.name.empty(), "--device");
    refuse(!command.device.shaders.empty(), "--shaders");
    refuse(command.device.validation, "--validation");
    refuse(command.device.timeout.has_value(), "--device-timeout");
    refuse(!command.checkpoint.empty(), "--checkpoint");
    refuse(command.profile, "--profile");
    refuse(!command.savePhotons.empty(), "--save-photons");
    refuse(!command.loadPhotons.empty(), "--load-photons");
    refuse(!command.dumps.empty(), "--dump");
}

// The command that shows a pixel's path in this render, without the pixel and the pass.
std::string inspectCommand(const RenderCommand& command) {
    std::string text = "hyalite inspect " + command.scene;
    for (const SceneSetting& setting : command.settings.shorthands) {
        if (setting.value && setting.key != "render.passes") {
            text += " --set " + setting.key + '=' + *setting.value;
        }
    }
    for (const std::string& setting : command.settings.assignments) {
        text += " --set " + setting;
    }
    return text;
}

LayeredImage renderOnDevice(const RenderCommand& command, const Scene& scene, ProgressBar& bar, RenderReport& report) {
    const OpenDevice device(command.device);
    render::RenderOptions renderOptions;
    renderOptions.profile = command.profile;
    renderOptions.timeLimit = command.time;
    renderOptions.onPass = [&](const render::Progress& p) {
        bar.update({p.passes, p.ofPasses, p.seconds, command.time, p.errorEstimate, p.resumedFrom});
    };
    renderOptions.firstPass = command.firstPass;
    renderOptions.stop = [] { return InterruptWatch::signal() != nullptr; };
    renderOptions.checkpoint = {command.checkpoint, command.resume, command.checkpointEvery};
    renderOptions.photonFiles = {.save = command.savePhotons, .load = command.loadPhotons};
    std::vector<render::DumpRequest> requests;
    for (const std::string& dump : command.dumps) {
        requests.push_back(render::dumpRequest(dump));
        checkWritable(requests.back().file);
    }
    render::BufferDump dump(device.context(), std::move(requests));
    gpu::Observation observation;
    if (!command.dumps.empty()) {
        renderOptions.onUpload = [&](render::Device& renderer, const render::DeviceScene&) {
            observation = renderer.commands.observe(dump);
        };
    }
    render::RenderResult result = render::render(device.context(), device.compiler(), scene, renderOptions);
    report.device = device.context().info().name + ", " + device.context().info().driver;
    report.passes = result.passes;
    report.resumedFrom = result.resumedFrom;
    report.interrupted = result.stopped;
    report.checkpointFailure = std::move(result.checkpointFailure);
    report.errorEstimate = result.errorEstimate;
    report.setupSeconds = result.setupSeconds;
    report.renderSeconds = result.renderSeconds;
    report.counts = result.counts;
    report.notes = std::move(result.notes);
    std::ranges::move(
        render::faultWarnings(result.faults, result.layers, scene.camera.resolution, inspectCommand(command)),
        std::back_inserter(report.notes.warnings));
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
    options.afterPass = [&](std::uint32_t passes, const ErrorEstimate& error) {
        const render::Progress progress{passes, scene.render.passes, watch.seconds(), error.error};
        bar.update({passes, scene.render.passes, progress.seconds, command.time, error.error});
        report.passes = passes;
        report.errorEstimate = error;
        report.renderSeconds = progress.seconds;
        report.interrupted = InterruptWatch::signal() != nullptr && passes < scene.render.passes;
        return !report.interrupted && render::timeForAnotherPass(progress, command.time) &&
               !render::reachesTarget(progress, scene.render.targetError);
    };
    return render::renderByReference(scene, options);
}

// "a", "a and b", "a, b and c".
std::string listOf(const std::vector<std::string_view>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + std::string(words[i]);
    }
    return text;
}

template <class Predicate>
std::vector<std::string_view> integratorsThat(const Predicate& predicate) {
    std::vector<std::string_view> names;
    for (const render::IntegratorKind& kind : render::integratorKinds()) {
        if (predicate(kind)) {
            names.push_back(kind.name);
        }
    }
    return names;
}

// Whether this picture is the sum of several layers and the backend keeps them.
bool hasLayers(const render::IntegratorKind& kind, const RenderSettings& settings, bool byReference) {
    return kind.layers(settings).size() > 1 && (!byReference || kind.referenceHasLayers);
}

// Rejects options that have no effect with this integrator or these outputs.
void refuseUnused(const RenderCommand& command, const Scene& scene) {
    const render::IntegratorKind& integrator = render::integratorKind(scene);
    if (!integrator.keepsPhotons && !(command.savePhotons.empty() && command.loadPhotons.empty())) {
        const auto keepers = integratorsThat([](const auto& kind) { return kind.keepsPhotons; });
        throw Error(ExitCode::WrongUsage, "only integrator " + listOf(keepers) + " saves and loads photon maps",
                    "add --integrator " + std::string(keepers.front()));
    }
    const bool anyExr = std::ranges::any_of(
        command.outputs, [](const std::string& output) { return std::filesystem::path(output).extension() == ".exr"; });
    const bool byReference = command.backend == "reference";
    if (command.layers && !hasLayers(integrator, scene.render, byReference) && scene.render.passes == 1) {
        const auto layered =
            integratorsThat([&](const auto& kind) { return hasLayers(kind, RenderSettings(), byReference); });
        throw Error(ExitCode::WrongUsage,
                    "--layers has no effect here: the picture has no layers, and one pass gives no error estimate",
                    "integrators with layers" + std::string(byReference ? " in the reference" : "") + ": " +
                        listOf(layered) + "; the error estimate needs two passes");
    }
    if (command.layers && !anyExr) {
        throw Error(ExitCode::WrongUsage, "--layers needs an .exr file to write to", "add -o FILE.exr");
    }
    if (!command.savePhotons.empty()) {
        checkWritable(command.savePhotons);
    }
}

// Only --resume overwrites an existing checkpoint.
void checkCheckpoint(const RenderCommand& command) {
    if (command.checkpoint.empty()) {
        if (command.resume) {
            throw Error(ExitCode::WrongUsage, "--resume needs a checkpoint to continue from", "add --checkpoint FILE");
        }
        return;
    }
    if (!command.resume && std::filesystem::exists(command.checkpoint)) {
        throw Error(ExitCode::WrongUsage, SourceLocation{command.checkpoint}, "the checkpoint already exists",
                    "continue from it with --resume, or remove it");
    }
    checkWritable(command.checkpoint);
}

// --passes FIRST:END renders only those passes, numbered as in a render of all passes.
void splitPassRange(RenderCommand& command) {
    for (SceneSetting& setting : command.settings.shorthands) {
        const std::size_t colon =
            setting.key == "render.passes" && setting.value ? setting.value->find(':') : std::string::npos;
        if (colon == std::string::npos) {
            continue;
        }
        const auto first = parseWhole(setting.value->substr(0, colon));
        const auto end = parseWhole(setting.value->substr(colon + 1));
        if (!first || !end || *first < 0 || *first >= *end || *end > std::numeric_limits<std::uint32_t>::max()) {
            throw Error(ExitCode::WrongUsage, SourceLocation{setting.option},
                        "invalid range of passes '" + *setting.value + "'",
                        "write FIRST:END, e.g. 0:64 for passes 0 to 63");
        }
        command.firstPass = static_cast<std::uint32_t>(*first);
        setting.value = std::to_string(*end - *first);
    }
    if (command.firstPass > 0 && command.backend == "reference") {
        throw Error(ExitCode::WrongUsage, "--backend reference does not support a range of passes");
    }
}

void renderScene(RenderCommand command, ExitCode& exit) {
    const Stopwatch watch;
    const bool byReference = command.backend == "reference";
    if (byReference) {
        refuseDeviceOptions(command);
    }
    splitPassRange(command);
    checkCheckpoint(command);
    const InterruptWatch watchForSignals;
    Scene scene = loadScene(command.scene);
    if (byReference) {
        reference::attachTwins(scene, twinSources(command.twins));
    } else if (!command.twins.empty()) {
        throw Error(ExitCode::WrongUsage, "--backend vulkan does not support --twins");
    }
    applySettings(scene, command.settings.given());
    if (command.outputs.empty()) {
        command.outputs.push_back(std::filesystem::path(command.scene).stem().string() + ".png");
    }
    for (const std::string& output : command.outputs) {
        checkImageWritable(output);
    }
    refuseUnused(command, scene);

    RenderReport report;
    report.sceneWarnings = textsOf(warningsOf(scene));
    printWarnings(report.sceneWarnings, command.strict);
    report.scene = command.scene;
    report.integrator = scene.render.integrator;
    report.backend = command.backend;
    report.seed = scene.render.seed;
    report.sampler = nameOf(scene.render.sampler);
    report.targetError = scene.render.targetError;
    report.resolution = scene.camera.resolution;
    report.outputs = command.outputs;
    LayeredImage image;
    {
        ProgressBar bar(!command.quiet && !command.json);
        image =
            byReference ? renderByReference(command, scene, bar, report) : renderOnDevice(command, scene, bar, report);
    }
    writePictures(command.outputs, image, command.layers, pictureMetadata(report));
    report.totalSeconds = watch.seconds();
    if (const auto black = render::blackPicture(image.picture, scene)) {
        report.notes.warnings.push_back(black->text());
    }
    warnOfTarget(report);

    printReport(report, {.json = command.json, .profile = command.profile, .quiet = command.quiet});
    printWarnings(report.notes.warnings, command.strict && !report.interrupted && !report.checkpointFailure);
    if (report.checkpointFailure) {
        throw Error(*report.checkpointFailure);
    }
    if (report.interrupted) {
        std::cerr << "hyalite: " << InterruptWatch::signal() << ": stopped after " << report.passes
                  << (report.passes == 1 ? " pass" : " passes") << "; wrote the picture so far"
                  << (command.checkpoint.empty() ? "" : "; --resume continues from the checkpoint") << '\n';
        exit = ExitCode::Interrupted;
    }
}

} // namespace

void addRender(CLI::App& app, ExitCode& exit) {
    const auto command = std::make_shared<RenderCommand>();
    CLI::App* sub = app.add_subcommand("render", "render a scene to pictures");
    sub->add_option("SCENE", command->scene, "scene file (YAML)")->required();
    sub->add_option("-o,--output", command->outputs, "picture to write, .png or .exr; may be given several times");
    command->settings.addTo(*sub);
    CLI::Option* passes = sub->get_option("--passes");
    passes->description(passes->get_description() + "; FIRST:END: only passes FIRST to END - 1, see hyalite merge");
    sub->get_option("--samples")->excludes("--passes");
    sub->add_option("--backend", command->backend, "vulkan or reference (CPU, double precision)")
        ->check(CLI::IsMember({"vulkan", "reference"}));
    addTwinOption(*sub, command->twins);
    addDeviceOptions(*sub, command->device);
    sub->add_option("--time", command->time, "time limit for rendering [s]: stop before a pass that would exceed it")
        ->check(finiteNumber(/*zeroAllowed*/ false));
    sub->add_flag("--layers", command->layers,
                  "also write the layers that add up to the picture, and its standard error, into .exr files");
    sub->add_option("--checkpoint", command->checkpoint, "save the passes to this file, periodically and at the end");
    sub->add_flag("--resume", command->resume, "continue from the checkpoint if it exists");
    sub->add_option("--checkpoint-every", command->checkpointEvery, "seconds between checkpoints (60)")
        ->check(finiteNumber(/*zeroAllowed*/ true))
        ->needs("--checkpoint");
    sub->add_option("--save-photons", command->savePhotons, "photonmap: write the photon maps to this file");
    sub->add_option("--load-photons", command->loadPhotons,
                    "photonmap: read the photon maps from this file instead of tracing them");
    sub->add_option("--dump", command->dumps,
                    "write an array that a stage uses, after its first dispatch (@N: dispatch N), to "
                    "STAGE.FIELD.npy, e.g. trace_closest:hits.t")
        ->type_name("STAGE:FIELD[@N]");
    sub->add_flag("--profile", command->profile, "print tables of stage times and buffer sizes");
    sub->add_flag("--json", command->json, "print one JSON object instead of text");
    sub->add_flag("--quiet", command->quiet, "print nothing but warnings and errors");
    addStrictOption(*sub, command->strict);
    sub->callback([command, &exit] { renderScene(*command, exit); });
}

} // namespace hyalite::cli
