#include "bench/benchmark.h"

#include "bench/device_tracer.h"
#include "bench/embree_tracer.h"
#include "bench/photon_stages.h"
#include "bench/timing.h"
#include "render/renderer.h"

#include <algorithm>
#include <cmath>

namespace hyalite::bench {

namespace {

// Ends of two tracers count as the same point up to this difference, relative to the distance, or in metres below 1 m:
// the rounding of coordinates of a few metres, at a grazing angle.
constexpr float kSamePlace = 1e-3F;

// A scene on the device, with the kernels of one folder.
struct Uploaded {
    render::Device device;
    render::DeviceScene deviceScene;

    Uploaded(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene)
        : device(context, compiler, false), deviceScene(render::uploadScene(context, device.tables, scene)) {}
};

double shareAgreeing(const std::vector<float>& a, const std::vector<float>& b) {
    std::size_t same = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool both = std::isfinite(a[i]) && std::isfinite(b[i]);
        same += both ? std::abs(a[i] - b[i]) <= kSamePlace * std::max(1.0F, a[i]) : a[i] == b[i];
    }
    return static_cast<double>(same) / static_cast<double>(a.size());
}

double medianRatio(const std::vector<Run>& a, const std::vector<Run>& b, double Run::* member) {
    std::vector<double> ratios;
    std::ranges::transform(a, b, std::back_inserter(ratios),
                           [&](const Run& x, const Run& y) { return x.*member / y.*member; });
    return median(ratios);
}

struct NamedTracer {
    std::string name;
    std::unique_ptr<RayTracer> tracer;
};

// Measures the first tracer against the others, alternately.
StageResult measureRays(const RaySet& set, const std::vector<NamedTracer>& tracers, int runs) {
    std::vector<std::vector<Run>> times(tracers.size());
    for (const NamedTracer& each : tracers) {
        each.tracer->load(set);
        each.tracer->trace(); // kernels are compiled at their first dispatch
    }
    for (int run = 0; run < runs; ++run) {
        for (std::size_t i = 0; i < tracers.size(); ++i) {
            times[i].push_back(timeOf([&] { tracers[i].tracer->trace(); }));
        }
    }
    StageResult result{set.name, "rays", set.rays.size(), times[0], {}};
    const std::vector<float> ends = tracers[0].tracer->ends();
    for (std::size_t i = 1; i < tracers.size(); ++i) {
        result.rivals.push_back({tracers[i].name, times[i], medianRatio(times[i], times[0], &Run::seconds),
                                 medianRatio(times[i], times[0], &Run::cores),
                                 shareAgreeing(ends, tracers[i].tracer->ends())});
    }
    return result;
}

void measureRaySets(Uploaded& uploaded, Uploaded* other, const Scene& scene, const BenchOptions& options,
                    SceneResult& result) {
    std::vector<RaySet> sets = makeRaySets(uploaded.device, scene, uploaded.deviceScene);
    std::erase_if(sets, [&](const RaySet& set) { return !options.wants(set.name); });
    if (sets.empty()) {
        return;
    }
    std::vector<NamedTracer> tracers;
    tracers.push_back({"device", std::make_unique<DeviceTracer>(uploaded.device, uploaded.deviceScene)});
    if (other != nullptr) {
        tracers.push_back({"other shaders", std::make_unique<DeviceTracer>(other->device, other->deviceScene)});
    }
    if (auto embree = makeEmbreeTracer(scene)) {
        tracers.push_back({embreeVersion(), std::move(embree)});
    }
    for (const RaySet& set : sets) {
        result.stages.push_back(measureRays(set, tracers, options.runs));
    }
}

void measureRender(const gpu::Context& context, const gpu::ShaderCompiler& compiler, Scene scene,
                   const BenchOptions& options, SceneResult& result) {
    scene.render.passes = static_cast<std::uint32_t>(options.runs) + 1;
    scene.render.targetError = 0;
    std::vector<Run> passes;
    RunClock clock;
    render::RenderOptions renderOptions;
    renderOptions.onPass = [&](const render::Progress&) {
        passes.push_back(clock.elapsed());
        clock = RunClock();
    };
    static_cast<void>(render::render(context, compiler, scene, renderOptions));
    if (options.wants("start")) {
        result.stages.push_back({"start", "pictures", 1, {passes.front()}, {}});
    }
    if (options.wants("render")) {
        result.stages.push_back({"render", "passes", 1, {passes.begin() + 1, passes.end()}, {}});
    }
}

} // namespace

const std::vector<std::string>& stageNames() {
    static const std::vector<std::string> names = {"scene", "camera", "shadow", "bounce",   "shuffled", "photons",
                                                   "grid",  "gather", "tree",   "estimate", "start",    "render"};
    return names;
}

SceneResult measureScene(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                         const BenchOptions& options) {
    SceneResult result{.scene = scene.file, .objects = scene.objects.size(), .triangles = 0, .stages = {}};
    for (const Mesh& mesh : scene.meshes) {
        result.triangles += mesh.triangles.size();
    }
    if (options.wants("scene")) {
        result.stages.push_back({"scene",
                                 "objects",
                                 result.objects + result.triangles,
                                 timesOf(options.runs, [&] { const Uploaded uploaded(context, compiler, scene); }),
                                 {}});
    }
    Uploaded uploaded(context, compiler, scene);
    std::optional<gpu::ShaderCompiler> otherCompiler;
    std::optional<Uploaded> other;
    if (!options.against.empty()) {
        otherCompiler.emplace(options.against);
        other.emplace(context, *otherCompiler, scene);
    }
    measureRaySets(uploaded, other ? &*other : nullptr, scene, options, result);
    measurePhotonStages(uploaded.device, scene, uploaded.deviceScene, options, result);
    if (options.wants("start") || options.wants("render")) {
        measureRender(context, compiler, scene, options, result);
    }
    return result;
}

std::vector<KernelResult> measureKernels(const gpu::Context& context, const gpu::ShaderCompiler& compiler) {
    const gpu::ShaderCompiler uncached(compiler.shaders());
    gpu::TexelTables tables(context, TABLE_COUNT);
    gpu::Commands commands(context, tables);
    std::vector<KernelResult> results;
    for (const auto& entry : std::filesystem::directory_iterator(compiler.shaders() / "kernels")) {
        if (entry.path().extension() != ".comp") {
            continue;
        }
        KernelResult result{.kernel = entry.path().stem().string()};
        result.compileSeconds = timeOf([&] { static_cast<void>(uncached.compile(result.kernel)); }).seconds;
        static_cast<void>(compiler.compile(result.kernel)); // now it is in the cache
        std::optional<gpu::Kernel> kernel;
        result.pipelineSeconds = timeOf([&] { kernel.emplace(context, tables, compiler, result.kernel); }).seconds;
        for (const auto& [binding, format] : kernel->interface().tables) {
            tables.set(binding, gpu::Buffer(), format);
        }
        result.firstSeconds = timeOf([&] {
                                  commands.prepare(*kernel);
                                  commands.finish();
                              }).seconds;
        results.push_back(result);
    }
    std::ranges::sort(results, {}, &KernelResult::kernel);
    return results;
}

} // namespace hyalite::bench
