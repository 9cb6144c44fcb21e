#include "live/worker/live_renderer.h"

#include "base/stopwatch.h"
#include "parity/inspection_session.h"
#include "reference/bsdf/custom_twins.h"
#include "render/integrators/registry.h"
#include "render/picture_check.h"
#include "render/upload/custom_code.h"
#include "render/wavefront/learn_lights.h"
#include "scene/checks/light_check.h"
#include "scene/load/load_scene.h"
#include "scene/model/integrators.h"
#include "scene/yaml/settings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hyalite::live {

namespace {

// Longest time for a preview [s]. With the time for the messages, the picture still seems to follow the hand.
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
    auto loaded = std::make_unique<Loaded>();
    loaded->scene = loadScene(file);
    reference::attachTwins(loaded->scene, twins);
    loaded->folder = file.parent_path();
    Scene seen = withView(*loaded, view_);
    drop();
    try {
        loaded->device = render::uploadScene(context_, device_.tables, loaded->scene);
    } catch (const Error&) {
        if (loaded_) { // the tables may refer to the new scene's buffers, which are gone
            loaded_->device = render::uploadScene(context_, device_.tables, loaded_->scene);
        }
        throw;
    }
    device_.finishKernels(); // kernels in the making read the code that is replaced now
    device_.forget(compiler_.takeChanged());
    useCodeOf(seen);
    loaded_ = std::move(loaded);
    show(std::move(seen), /*isNew*/ true);
}

void LiveRenderer::useCodeOf(const Scene& scene) {
    std::map<std::string, std::string> code = render::customCode(scene);
    if (code == code_) {
        return;
    }
    code_ = std::move(code);
    device_.finishKernels(); // likewise
    compiler_.replace(code_);
    device_.forget(compiler_.takeChanged());
}

Scene LiveRenderer::withView(const Loaded& loaded, const View& view) {
    Scene seen = loaded.scene;
    const std::string page = (loaded.folder / "page").string(); // where names of files in settings start
    std::vector<SettingAssignment> assignments;
    for (const auto& [key, value] : view.settings) {
        assignments.push_back({key, value, page});
    }
    try {
        applySettings(seen, assignments);
    } catch (const Error& error) {
        const bool isAtSetting = error.where().file == page;
        throw Error(error.code(), isAtSetting ? SourceLocation{.file = "page"} : error.where(), error.message(),
                    error.hint());
    }
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
        Scene seen = withView(*loaded_, view);
        drop();
        useCodeOf(seen);
        show(std::move(seen), /*isNew*/ false);
    }
    view_ = std::move(view);
}

void LiveRenderer::show(Scene seen, bool isNew) {
    // Not for every move of the camera: the warnings are those of the view in which the scene was loaded
    if (isNew || seen.render.integrator != scene_.render.integrator) {
        lightWarnings_ = checks::lightWarnings(seen);
    }
    scene_ = std::move(seen);
}

void LiveRenderer::forget(const std::set<std::string>& kernels) {
    drop();
    device_.forget(kernels);
}

void LiveRenderer::drop() {
    device_.commands.finish(); // recorded commands name buffers that are freed now
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
    loaded_->device.camera = render::cameraRecord(run->scene);
    const render::IntegratorKind& kind = render::integratorKind(run->scene);
    run->film.emplace(device_, run->scene.camera.resolution,
                      quantity ? render::DebugView::layers() : kind.layers(run->scene.render));
    const render::IntegratorInput input{
        .device = device_, .scene = run->scene, .deviceScene = loaded_->device, .film = *run->film};
    try {
        if (quantity) {
            run->scene.render.passes = 1;
            run->integrator = std::make_unique<render::DebugView>(input, *quantity);
        } else {
            run->integrator = kind.make(input);
        }
    } catch (...) {
        device_.commands.finish(); // recorded commands name the film's buffers, which are freed now
        throw;
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
    guard_.mayInterrupt(!isPreview);
    prints_.listen(false, shared::kNone);
    run_ = makeRun(std::move(scene), debugQuantity(view_.shown), isPreview);
    if (!isPreview && !debugQuantity(view_.shown)) {
        render::learnLights(device_, run_->scene, loaded_->device);
    }
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
    // By a bounded step towards the size that takes the time allowed: a single pass may have compiled kernels
    const double share = std::clamp(kPreviewSeconds / seconds, 0.6, 1.4);
    previewPixels_ = std::clamp(previewPixels_ * share, kFewest, kMost);
}

bool LiveRenderer::isDone() const {
    return run_ == nullptr || run_->passes >= run_->scene.render.passes;
}

LiveRenderer::Frame LiveRenderer::frame() {
    const Activity activity(pulse_, kBetweenKernels);
    Frame frame;
    {
        const DispatchGuard::Uninterrupted scope(guard_); // the passes are done: show what they cost
        frame.image = run_->film->resolve(device_);
        frame.error = run_->film->estimateError(device_).error;
    }
    frame.isPreview = run_->isPreview;
    frame.passes = run_->passes;
    frame.ofPasses = run_->scene.render.passes;
    frame.stages = timesOfPass_;
    frame.counts = run_->integrator->counts();
    frame.notes = run_->integrator->notes();
    const auto add = [&](const Warning& warning) { frame.notes.warnings.push_back(warning.text()); };
    std::ranges::for_each(scene_.warnings, add);
    std::ranges::for_each(lightWarnings_, add);
    if (isDone() && !run_->isPreview && !debugQuantity(view_.shown)) {
        if (const auto black = render::blackPicture(frame.image.picture, scene_)) {
            add(*black);
        }
    }
    return frame;
}

parity::RecordedPath LiveRenderer::inspect(std::uint32_t pixel) {
    const Activity activity(pulse_, kBetweenKernels);
    prints_.listen(false, shared::kNone);
    const DispatchGuard::Uninterrupted scope(guard_);
    loaded_->device.camera = render::cameraRecord(scene_);
    return parity::InspectionSession(device_, scene_, loaded_->device).followPixel(pixel, 0);
}

} // namespace hyalite::live
