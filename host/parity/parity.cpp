#include "parity/parity.h"

#include "image/flip.h"
#include "image/metrics.h"
#include "parity/capture.h"
#include "reference/bsdf/custom_twins.h"
#include "reference/render.h"
#include "render/renderer.h"
#include "render/wavefront/device.h"
#include "scene/model/render_seed.h"

#include <algorithm>
#include <utility>

namespace hyalite::parity {

namespace {

constexpr std::uint32_t kTestSide = 64;
constexpr std::uint32_t kTestPasses = 2;
constexpr std::uint32_t kTestPhotons = 8192;

constexpr std::uint32_t kMostShown = 128 * 128; // paths that a page has room for

PictureResult comparePictures(Image device, Image twin) {
    const Crop whole = wholeOf(twin);
    PictureResult result;
    result.rmse = rmse(device, twin, whole);
    result.relMse = relMse(device, twin, whole);
    result.flipMap = flipMap(device, twin);
    result.flip = mean(result.flipMap, whole);
    result.shareWithin = shareWithin(device, twin, kPictureTolerance, whole);
    result.device = std::move(device);
    result.twin = std::move(twin);
    return result;
}

// One pass of a scene, all paths of which are written down.
class Recording {
public:
    Recording(const gpu::Context& context, const gpu::ShaderCompiler& compiler, Scene scene, std::uint32_t pass)
        : scene_(std::move(scene)) {
        scene_.render.passes = 1;
        render::RenderOptions options;
        options.firstPass = pass;
        options.onUpload = [&](render::Device& device, const render::DeviceScene& deviceScene) {
            sides_.emplace(scene_, deviceScene);
            capture_.emplace(context, device.tables, *sides_, std::set<std::string>{"nothing"});
            observation_ = device.commands.observe(*capture_);
        };
        static_cast<void>(render::render(context, compiler, scene_, options));
    }

    [[nodiscard]] RecordedPath path(const PathKey& key) const { return pathOf(*sides_, capture_->recorder(), key); }
    [[nodiscard]] const auto& photonPasses() const { return capture_->recorder().photonPasses(); }

private:
    Scene scene_;
    std::optional<Sides> sides_;
    std::optional<Capture> capture_;
    gpu::Observation observation_;
};

} // namespace

bool PictureResult::passed() const {
    return shareWithin >= kPictureShare;
}

bool Result::passed() const {
    return std::ranges::all_of(stages, &StageResult::passed) &&
           (!paths || (paths->camera.passed() && paths->photons.passed())) && (!picture || picture->passed());
}

const StageResult* Result::firstFailure() const {
    const StageResult* first = nullptr;
    for (const StageResult& stage : stages) {
        if (!stage.passed() && (first == nullptr || stage.failureOrder() < first->failureOrder())) {
            first = &stage;
        }
    }
    return first;
}

Result compareSides(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                    const Options& options) {
    std::optional<Sides> sides;
    std::optional<Capture> capture;
    gpu::Observation observation;
    render::RenderOptions renderOptions;
    renderOptions.onUpload = [&](render::Device& device, const render::DeviceScene& deviceScene) {
        sides.emplace(scene, deviceScene);
        capture.emplace(context, device.tables, *sides, options.stages);
        observation = device.commands.observe(*capture);
    };
    render::RenderResult rendered = render::render(context, compiler, scene, renderOptions);
    Result result;
    result.stages = capture->finish();
    if (options.stages.empty() && reference::codeWithoutTwin(scene) == nullptr) {
        result.paths = comparePaths(*sides, capture->recorder());
        const std::uint32_t pixels = scene.camera.resolution.x * scene.camera.resolution.y;
        for (std::uint32_t pixel = 0; pixels <= kMostShown && pixel < pixels; ++pixel) {
            result.shown.push_back(pathOf(*sides, capture->recorder(), {false, 0, pixel}));
        }
        result.picture = comparePictures(std::move(rendered.image.picture), reference::render(scene).picture);
    }
    return result;
}

RecordedPath inspectPixel(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                          std::uint32_t pass, std::uint32_t pixel) {
    const Recording recording(context, compiler, scene, pass);
    return recording.path({false, pass, pixel});
}

RecordedPath inspectPhoton(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                           std::uint32_t pass, const PhotonChoice& photon) {
    const Recording recording(context, compiler, scene, pass);
    const std::uint32_t purpose = photon.isCaustic ? shared::kCausticPhotons : shared::kGlobalPhotons;
    const std::uint32_t photonPass = scene.render.integrator == Integrator::PhotonMap ? 0 : pass; // maps are made once
    const std::uint32_t sequence = shared::photonSequence(renderSeed(scene.render), purpose, photonPass);
    const auto& sent = recording.photonPasses();
    const auto found = sent.find(sequence);
    if (found == sent.end()) {
        throw Error(ExitCode::WrongUsage,
                    photon.isCaustic ? "no caustic photons are sent in this render"
                                     : "this integrator sends no photons",
                    photon.isCaustic ? "leave --caustic out" : "ask for a pixel with --pixel X,Y");
    }
    if (photon.number >= found->second.pass.count) {
        throw Error(ExitCode::WrongUsage, "there is no photon " + std::to_string(photon.number) + " among " +
                                              std::to_string(found->second.pass.count));
    }
    return recording.path({true, sequence, photon.number});
}

void shrinkToTestSize(Scene& scene) {
    glm::uvec2& resolution = scene.camera.resolution;
    const std::uint32_t side = std::max(resolution.x, resolution.y);
    if (side > kTestSide) {
        resolution = glm::max(glm::uvec2(1), (resolution * kTestSide + side / 2) / side);
    }
    RenderSettings& render = scene.render;
    render.passes = std::min(render.passes, kTestPasses);
    render.photons = std::min(render.photons, kTestPhotons);
    render.photonMap.causticPhotons = std::min(render.photonMap.causticPhotons, kTestPhotons);
}

} // namespace hyalite::parity
