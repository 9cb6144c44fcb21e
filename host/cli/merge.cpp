// `hyalite merge`: merges passes of one render, made on any machines, into the picture that a single render of all
// passes gives.
#include "base/numbers.h"
#include "base/output_file.h"
#include "base/stopwatch.h"
#include "cli/command.h"
#include "cli/open_device.h"
#include "cli/render_report.h"
#include "cli/strict.h"
#include "image/image_io.h"
#include "render/film/checkpoint.h"
#include "render/picture_check.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace hyalite::cli {

namespace {

struct MergeCommand {
    std::vector<std::string> parts;
    std::vector<std::string> outputs;
    std::string checkpoint;
    DeviceChoice device;
    bool layers = false;
    bool json = false;
    bool quiet = false;
    bool strict = false;
};

void checkOutputs(const MergeCommand& command) {
    if (command.outputs.empty() && command.checkpoint.empty()) {
        throw Error(ExitCode::WrongUsage, "merge has nothing to write", "add -o FILE.png or --checkpoint FILE");
    }
    for (const std::string& output : command.outputs) {
        checkImageWritable(output);
    }
    if (!command.checkpoint.empty()) {
        if (std::filesystem::exists(command.checkpoint)) {
            throw Error(ExitCode::WrongUsage, SourceLocation{command.checkpoint}, "the checkpoint already exists",
                        "remove it, or choose another name");
        }
        checkWritable(command.checkpoint);
    }
}

render::Checkpoint readParts(const std::vector<std::string>& parts) {
    render::Checkpoint whole = render::readCheckpoint(parts.front());
    for (std::size_t i = 1; i < parts.size(); ++i) {
        render::addCheckpoint(whole, render::readCheckpoint(parts[i]), parts[i]);
    }
    return whole;
}

void merge(const MergeCommand& command) {
    const Stopwatch watch;
    checkOutputs(command);
    const render::Checkpoint whole = readParts(command.parts);
    RenderReport report;
    report.scene = whole.identity.scene;
    report.integrator = whole.identity.setting("render.integrator");
    report.backend = "vulkan";
    report.seed = static_cast<std::uint32_t>(parseWhole(whole.identity.setting("render.seed")).value_or(0));
    report.sampler = whole.identity.setting("render.sampler");
    report.resolution = whole.film.resolution;
    report.outputs = command.outputs;
    report.counts = whole.counts;
    report.renderSeconds = whole.seconds;
    report.notes.warnings =
        render::faultWarnings(whole.film.faults, whole.film.layers, whole.film.resolution, "hyalite inspect SCENE");
    if (!command.checkpoint.empty()) {
        render::writeCheckpoint(command.checkpoint, whole);
    }
    const OpenDevice device(command.device);
    const render::RenderResult result = render::resolve(device.context(), device.compiler(), whole.film);
    report.device = device.context().info().name + ", " + device.context().info().driver;
    report.passes = result.passes;
    report.errorEstimate = result.errorEstimate;
    device.checkValidation();
    writePictures(command.outputs, result.image, command.layers, pictureMetadata(report));
    report.totalSeconds = watch.seconds();
    if (const auto black = render::blackPicture(result.image.picture, report.scene)) {
        report.notes.warnings.push_back(black->text());
    }
    printReport(report, {.json = command.json, .quiet = command.quiet});
    printWarnings(report.notes.warnings, command.strict);
}

} // namespace

void addMerge(CLI::App& app) {
    const auto command = std::make_shared<MergeCommand>();
    CLI::App* sub = app.add_subcommand("merge", "merge the passes of several checkpoints");
    sub->add_option("PART", command->parts,
                    "checkpoints of one render, each with different passes (render --passes "
                    "0:64 --checkpoint PART)")
        ->required();
    sub->add_option("-o,--output", command->outputs, "picture to write, .png or .exr; may be given several times");
    sub->add_option("--checkpoint", command->checkpoint, "write the merged passes to this checkpoint");
    addDeviceOptions(*sub, command->device);
    sub->add_flag("--layers", command->layers,
                  "also write the layers that add up to the picture, and its standard error, into .exr files");
    sub->add_flag("--json", command->json, "print one JSON object instead of text");
    sub->add_flag("--quiet", command->quiet, "print nothing but warnings and errors");
    addStrictOption(*sub, command->strict);
    sub->callback([command] { merge(*command); });
}

} // namespace hyalite::cli
