#include "live/live_renderer.h"

#include "base/stopwatch.h"
#include "parity/inspection_session.h"
#include "reference/bsdf/custom_twins.h"
#include "render/integrators/registry.h"
#include "render/upload/custom_code.h"
#include "scene/load/load_scene.h"
#include "scene/model/integrators.h"
#include "scene/yaml/settings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hyalite::live {

namespace {

// First pictures should take no longer [s]: with the camera's way to the worker and the picture's to the page, an eye
// still takes them for the answer to its hand.
constexpr double kPreviewSeconds = 0.06;
constexpr std::uint32_t kFewestPhotons = 2000;

std::optional<render::DebugQuantity> debugQuantity(const std::string& shown) {
    constexpr std::array<std::pair<std::string_view, render::DebugQuantity>, 3> kQuantities{
        {{"normals", render::DebugQuantity::Normals},
         {"depth", render::DebugQuantity::Depth},
         {"bounces", render::DebugQuantity::Bounces}}};
    for (const auto& [name, quantity] : kQuantities) {
        if (shown == name) {
            return quantity;
        }
    }
    return std::nullopt;
}

std::map<std::string, gpu::StageTime> difference(const std::map<std::string, gpu::StageTime>& now,
                                                 const std::map<std::string, gpu::StageTime>& before) {
    std::map<std::string, gpu::StageTime> times;
    for (const auto& [name, time] : now) {
        const auto found = before.find(name);
        const gpu::StageTime base = found == before.end() ? gpu::StageTime() : found->second;
        if (time.dispatches > base.dispatches) {
            times[name] = {time.seconds - base.seconds, time.dispatches - base.dispatches, time.threads - base.threads};
        }
    }
    return times;
}

} // namespace

LiveRenderer::LiveRenderer(const gpu::Context& context, ReloadingCompiler& compiler, Pulse& pulse,
                           std::function<bool()> isUnwanted)
    : context_(context), compiler_(compiler), pulse_(pulse), device_(context, compiler, /*timed*/ true),
      prints_(context, device_.tables), guard_(pulse, prints_, std::move(isUnwanted)) {
    observation_ = device_.commands.observe(guard_);
}

void LiveRenderer::load(const std::filesystem::path& file, const reference::TwinSources& twins) {
    Scene scene = loadScene(file);
    reference::attachTwins(scene, twins);
    Scene seen = withView(scene, view_);
    drop();
    auto loaded = std::make_unique<Loaded>();
    loaded->scene = std::move(scene);
    try {
        loaded->device = render::uploadScene(context_, device_.tables, loaded->scene);
    } catch (const Error&) {
        if (loaded_) { // the tables show what has gone away
            loaded_->device = render::uploadScene(context_, device_.tables, loaded_->scene);
        }
        throw;
    }
    device_.finishKernels(); // they read what is replaced now
    compiler_.replace(render::customCode(seen));
    device_.forget(compiler_.takeChanged());
    loaded_ = std::move(loaded);
    scene_ = std::move(seen);
}

Scene LiveRenderer::withView(const Scene& scene, const View& view) const {
    Scene seen = scene;
    std::vector<SettingAssignment> assignments;
    for (const auto& [key, value] : view.settings) {
        assignments.push_back({key, value, "page"});
    }
    applySettings(seen, assignments);
    if (view.shown != "picture" && !debugQuantity(view.shown)) {
        const IntegratorRow* reader = soleReader("view");
        if (reader != nullptr && seen.render.integrator != reader->name) {
            seen.render.maxDepth = std::max(seen.render.maxDepth, 1U);
            applySetting(seen, "render.integrator", std::string(reader->name), "page");
        }
        applySetting(seen, "render.view", view.shown, "page");
    }
    return seen;
}

void LiveRenderer::look(View view) {
    if (loaded_) {
        Scene seen = withView(loaded_->scene, view);
        drop();
        scene_ = std::move(seen);
    }
    view_ = std::move(view);
}

void LiveRenderer::forget(const std::set<std::string>& kernels) {
    drop();
    device_.forget(kernels);
}

void LiveRenderer::drop() {
    device_.commands.finish(); // what was recorded names buffers that go away now
    run_.reset();
}

bool LiveRenderer::wantsPreview() const {
    const glm::uvec2 size = scene_.camera.resolution;
    return static_cast<double>(size.x) * size.y > 1.5 * previewPixels_;
}

std::unique_ptr<LiveRenderer::Run> LiveRenderer::makeRun(Scene scene, std::optional<render::DebugQuantity> quantity,
                                                         bool isPreview) {
    auto run = std::make_unique<Run>();
    run->scene = std::move(scene);
    run->isPreview = isPreview;
    loaded_->device.camera = render::cameraRecord(run->scene.camera);
    const render::IntegratorKind& kind = render::integratorKind(run->scene);
    run->film.emplace(device_, run->scene.camera.resolution,
                      quantity ? render::DebugView::layers() : kind.layers(run->scene.render));
    const render::IntegratorInput input{
        .device = device_, .scene = run->scene, .deviceScene = loaded_->device, .film = *run->film};
    if (quantity) {
        run->scene.render.passes = 1;
        run->integrator = std::make_unique<render::DebugView>(input, *quantity);
    } else {
        run->integrator = kind.make(input);
    }
    return run;
}

void LiveRenderer::begin(bool isPreview) {
    const Activity activity(pulse_, kBetweenKernels);
    drop();
    Scene scene = scene_;
    if (isPreview) {
        glm::uvec2& size = scene.camera.resolution;
        const double divisor = std::sqrt(static_cast<double>(size.x) * size.y / previewPixels_);
        size = glm::max(glm::uvec2(1), glm::uvec2(glm::dvec2(size) / divisor));
        const auto fewer = [&](std::uint32_t count) {
            return std::min(count, std::max(kFewestPhotons, static_cast<std::uint32_t>(count / (divisor * divisor))));
        };
        scene.render.photons = fewer(scene.render.photons);
        scene.render.photonMap.causticPhotons = fewer(scene.render.photonMap.causticPhotons);
        scene.render.passes = 1;
    }
    guard_.mayStop(!isPreview);
    prints_.listen(false, shared::kNone);
    run_ = makeRun(std::move(scene), debugQuantity(view_.shown), isPreview);
    run_->integrator->prepare();
}

void LiveRenderer::renderPass() {
    const Activity activity(pulse_, kBetweenKernels);
    const Stopwatch watch;
    prints_.listen(!run_->isPreview && run_->passes == 0, view_.debugPixel);
    timesBefore_ = device_.commands.times();
    if (run_->passes == 0) {
        run_->integrator->begin();
    }
    run_->film->beginPass(run_->passes);
    run_->integrator->renderPass(run_->passes);
    run_->film->endPass();
    ++run_->passes;
    timesOfPass_ = difference(device_.commands.times(), timesBefore_);
    if (run_->isPreview) {
        adaptPreview(watch.seconds());
    }
}

void LiveRenderer::adaptPreview(double seconds) {
    constexpr double kFewest = 40.0 * 30.0;
    constexpr double kMost = 512.0 * 512.0;
    // Towards what would have taken the time allowed, not faster: one pass may compile kernels
    const double share = std::clamp(kPreviewSeconds / seconds, 0.6, 1.4);
    previewPixels_ = std::clamp(previewPixels_ * share, kFewest, kMost);
}

bool LiveRenderer::isDone() const {
    return run_ == nullptr || run_->passes >= run_->scene.render.passes;
}

LiveRenderer::Frame LiveRenderer::frame() {
    const Activity activity(pulse_, kBetweenKernels);
    Frame frame;
    guard_.mayStop(false); // a pass has been paid for
    frame.image = run_->film->resolve(device_);
    frame.error = run_->film->estimateError(device_);
    guard_.mayStop(!run_->isPreview);
    frame.isPreview = run_->isPreview;
    frame.passes = run_->passes;
    frame.ofPasses = run_->scene.render.passes;
    frame.stages = timesOfPass_;
    frame.counts = run_->integrator->counts();
    frame.notes = run_->integrator->notes();
    return frame;
}

parity::RecordedPath LiveRenderer::inspect(std::uint32_t pixel) {
    const Activity activity(pulse_, kBetweenKernels);
    guard_.mayStop(false);
    prints_.listen(false, shared::kNone);
    loaded_->device.camera = render::cameraRecord(scene_.camera);
    const parity::RecordedPath path = parity::InspectionSession(device_, scene_, loaded_->device).followPixel(pixel, 0);
    guard_.mayStop(run_ != nullptr && !run_->isPreview);
    return path;
}

} // namespace hyalite::live
