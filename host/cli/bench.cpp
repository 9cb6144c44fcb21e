// `hyalite bench`: measures the speed of each stage on this machine, next to a native ray tracer.
#include "bench/benchmark.h"
#include "bench/built_in_scenes.h"
#include "bench/embree_tracer.h"
#include "bench/timing.h"
#include "cli/command.h"
#include "cli/open_device.h"
#include "cli/shader_folder.h"
#include "cli/strict.h"
#include "scene/load/load_scene.h"

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

namespace hyalite::cli {

namespace {

using nlohmann::ordered_json;

constexpr const char* kKernels = "kernels";

struct BenchCommand {
    std::vector<std::string> scenes;
    std::vector<std::string> stages;
    bench::BenchOptions options;
    DeviceChoice device;
    std::string against;
    bool json = false;
    bool strict = false;
};

struct BenchReport {
    std::string device;
    std::vector<bench::SceneResult> scenes;
    std::vector<bench::KernelResult> kernels;
    double seconds = 0;
};

Scene sceneNamed(const std::string& name, bool strict) {
    const auto& builtIn = bench::builtInScenes();
    if (std::ranges::find(builtIn, name) != builtIn.end()) {
        return bench::makeBuiltInScene(name);
    }
    Scene scene = loadScene(name);
    printWarnings(warningsOf(scene), strict);
    return scene;
}

BenchReport measure(BenchCommand command) {
    const bench::RunClock clock;
    BenchReport report;
    command.options.stages = {command.stages.begin(), command.stages.end()};
    if (!command.against.empty()) {
        command.options.against = findShaders(command.against);
    }
    const OpenDevice device(command.device);
    const gpu::Context& context = device.context();
    const gpu::ShaderCompiler& compiler = device.compiler();
    report.device = context.info().name + ", " + context.info().driver;
    if (command.options.wants(kKernels)) { // first, before the driver has compiled many of them
        report.kernels = bench::measureKernels(context, compiler);
    }
    if (command.options.stages != std::set<std::string>{kKernels}) {
        for (const std::string& name : command.scenes.empty() ? bench::builtInScenes() : command.scenes) {
            report.scenes.push_back(
                bench::measureScene(context, compiler, sceneNamed(name, command.strict), command.options));
        }
    }
    device.checkValidation();
    report.seconds = clock.elapsed().seconds;
    return report;
}

double rateOf(std::uint64_t count, const std::vector<bench::Run>& runs) {
    return static_cast<double>(count) / bench::median(runs, &bench::Run::seconds);
}

ordered_json runsJson(const std::vector<bench::Run>& runs, std::uint64_t count) {
    std::vector<double> seconds;
    std::ranges::transform(runs, std::back_inserter(seconds), &bench::Run::seconds);
    const auto [fastest, slowest] = std::ranges::minmax(seconds);
    return {{"seconds", bench::median(seconds)},
            {"fastest", fastest},
            {"slowest", slowest},
            {"core_seconds", bench::median(runs, &bench::Run::cores)},
            {"per_second", rateOf(count, runs)}};
}

ordered_json stageJson(const bench::StageResult& stage) {
    ordered_json object{{"stage", stage.stage}, {"unit", stage.unit}, {"count", stage.count}};
    object.update(runsJson(stage.runs, stage.count));
    object["rivals"] = ordered_json::array();
    for (const bench::Rival& rival : stage.rivals) {
        ordered_json entry{{"name", rival.name}};
        entry.update(runsJson(rival.runs, stage.count));
        entry["ratio"] = rival.ratio;
        entry["core_ratio"] = rival.coresRatio;
        entry["agreeing"] = rival.agreeing;
        object["rivals"].push_back(std::move(entry));
    }
    return object;
}

void printJson(const BenchReport& report, const BenchCommand& command) {
    ordered_json object{{"version", HYALITE_VERSION},
                        {"device", report.device},
                        {"cores", std::thread::hardware_concurrency()},
                        {"native", bench::embreeVersion()},
                        {"runs", command.options.runs},
                        {"seconds", report.seconds},
                        {"scenes", ordered_json::array()},
                        {"kernels", ordered_json::array()}};
    for (const bench::SceneResult& scene : report.scenes) {
        ordered_json entry{{"scene", scene.scene},
                           {"objects", scene.objects},
                           {"triangles", scene.triangles},
                           {"stages", ordered_json::array()}};
        for (const bench::StageResult& stage : scene.stages) {
            entry["stages"].push_back(stageJson(stage));
        }
        object["scenes"].push_back(std::move(entry));
    }
    for (const bench::KernelResult& kernel : report.kernels) {
        object["kernels"].push_back({{"kernel", kernel.kernel},
                                     {"compile_seconds", kernel.compileSeconds},
                                     {"pipeline_seconds", kernel.pipelineSeconds},
                                     {"first_dispatch_seconds", kernel.firstSeconds}});
    }
    std::cout << object.dump(2) << '\n';
}

// Three significant figures with k or M.
std::string scaled(double value) {
    const char* unit = value >= 1e6 ? " M" : value >= 1e3 ? " k" : " ";
    value /= value >= 1e6 ? 1e6 : value >= 1e3 ? 1e3 : 1;
    std::ostringstream text;
    text << std::fixed << std::setprecision(value < 10 ? 2 : value < 100 ? 1 : 0) << value << unit;
    return text.str();
}

// For each stage: wall time, busy cores, speed, and the same of the rivals.
void printScene(const bench::SceneResult& scene) {
    std::ostringstream table;
    table << scene.scene << ": " << scene.objects << " objects, " << scene.triangles << " triangles\n" << std::fixed;
    for (const bench::StageResult& stage : scene.stages) {
        const double seconds = bench::median(stage.runs, &bench::Run::seconds);
        const double busy = bench::median(stage.runs, &bench::Run::cores) / seconds;
        table << "  " << std::left << std::setw(9) << stage.stage << std::right << std::setw(9) << std::setprecision(2)
              << 1e3 * seconds << " ms x " << busy << " cores" << std::setw(18)
              << scaled(rateOf(stage.count, stage.runs)) + stage.unit + "/s";
        for (const bench::Rival& rival : stage.rivals) {
            table << "   " << rival.name << ' ' << scaled(rateOf(stage.count, rival.runs)) << stage.unit << "/s, ratio "
                  << rival.ratio << " (of core time " << rival.coresRatio << "), " << std::setprecision(4)
                  << 100 * rival.agreeing << " % agree" << std::setprecision(2);
        }
        table << '\n';
    }
    std::cout << table.str() << std::flush;
}

void printKernels(const std::vector<bench::KernelResult>& kernels) {
    std::ostringstream table;
    table << std::fixed << std::setprecision(1);
    const auto row = [&](const std::string& name, double compile, double pipeline, double first) {
        table << "  " << std::left << std::setw(24) << name << std::right << std::setw(10) << 1e3 * compile
              << std::setw(10) << 1e3 * pipeline << std::setw(10) << 1e3 * first << '\n';
    };
    bench::KernelResult sum;
    table << "kernels [ms]                GLSL  pipeline  dispatch\n";
    for (const bench::KernelResult& kernel : kernels) {
        row(kernel.kernel, kernel.compileSeconds, kernel.pipelineSeconds, kernel.firstSeconds);
        sum.compileSeconds += kernel.compileSeconds;
        sum.pipelineSeconds += kernel.pipelineSeconds;
        sum.firstSeconds += kernel.firstSeconds;
    }
    row("all", sum.compileSeconds, sum.pipelineSeconds, sum.firstSeconds);
    std::cout << table.str();
}

void runBench(const BenchCommand& command) {
    const BenchReport report = measure(command);
    if (command.json) {
        printJson(report, command);
        return;
    }
    std::cout << report.device << ", " << std::thread::hardware_concurrency() << " cores; medians of "
              << command.options.runs << " runs\n";
    for (const bench::SceneResult& scene : report.scenes) {
        printScene(scene);
    }
    if (!report.kernels.empty()) {
        printKernels(report.kernels);
    }
}

} // namespace

void addBench(CLI::App& app) {
    // Shared with the callback, which outlives this function.
    const auto command = std::make_shared<BenchCommand>();
    CLI::App* sub = app.add_subcommand("bench", "measure each stage: rays, photons, searches, kernels");
    std::vector<std::string> stages = bench::stageNames();
    stages.emplace_back(kKernels);
    std::string names;
    for (const std::string& name : bench::builtInScenes()) {
        names += (names.empty() ? "" : ", ") + name;
    }
    sub->add_option("SCENE", command->scenes, "scene files or built-in scenes: " + names + " (all built-in scenes)");
    sub->add_option("--stage", command->stages, "measure only these stages")->check(CLI::IsMember(stages));
    sub->add_option("--runs", command->options.runs, "runs of each stage; prints their median")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    sub->add_option("--photons", command->options.photons, "photons emitted")
        ->check(CLI::Range(1U, 1U << 26U))
        ->capture_default_str();
    addDeviceOptions(*sub, command->device);
    sub->add_option("--against", command->against,
                    "folder of other shaders: trace the rays with both in turn and print the ratio of their speeds");
    sub->add_flag("--json", command->json, "print one JSON object instead of a table");
    addStrictOption(*sub, command->strict);
    sub->callback([command] { runBench(*command); });
}

} // namespace hyalite::cli
