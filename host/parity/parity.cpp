#include "parity/parity.h"

#include "image/flip.h"
#include "image/metrics.h"
#include "reference/bsdf/custom_twins.h"
#include "render/integrators/registry.h"
#include "render/renderer.h"
#include "render/upload/custom_code.h"
#include "render/wavefront/device.h"
#include "render/wavefront/learn_lights.h"

#include <algorithm>
#include <utility>

namespace hyalite::parity {

namespace {

constexpr std::uint32_t kTestSide = 64;
constexpr std::uint32_t kTestPasses = 2;
constexpr std::uint32_t kTestPhotons = 8192;

constexpr std::uint32_t kMostShown = 128 * 128; // largest number of paths that a page can hold

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

// A scene uploaded to its own device, for inspecting single paths.
class Uploaded {
public:
    Uploaded(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene)
        : compiler_(compiler) {
        compiler_.replace(render::customCode(scene));
        device_.emplace(context, compiler_, false);
        deviceScene_ = render::uploadScene(context, device_->tables, scene);
        render::learnLights(*device_, scene, deviceScene_);
        session_.emplace(*device_, scene, deviceScene_);
    }

    Uploaded(const Uploaded&) = delete;
    Uploaded& operator=(const Uploaded&) = delete;
    ~Uploaded() = default;

    [[nodiscard]] InspectionSession& session() { return *session_; }

private:
    gpu::ShaderCompiler compiler_;
    std::optional<render::Device> device_;
    render::DeviceScene deviceScene_;
    std::optional<InspectionSession> session_;
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
    std::optional<InspectionSession> session;
    gpu::Observation observation;
    render::RenderOptions renderOptions;
    renderOptions.onUpload = [&](render::Device& device, const render::DeviceScene& deviceScene) {
        session.emplace(device, scene, deviceScene);
        observation = session->watch(options.stages);
        if (render::learnsLights(scene, deviceScene)) { // once more, seen by the twin
            static_cast<void>(render::tryLights(device, scene, deviceScene));
        }
    };
    render::RenderResult rendered = render::render(context, compiler, scene, renderOptions);
    Result result;
    result.stages = session->takeStages();
    if (options.stages.empty() && reference::codeWithoutTwin(scene) == nullptr) {
        result.paths = session->comparePaths();
        const std::uint32_t pixels = scene.camera.resolution.x * scene.camera.resolution.y;
        for (std::uint32_t pixel = 0; pixels <= kMostShown && pixel < pixels; ++pixel) {
            result.shown.push_back(session->path({false, 0, pixel}));
        }
        result.picture = comparePictures(std::move(rendered.image.picture), render::renderByReference(scene).picture);
    }
    return result;
}

RecordedPath inspectPixel(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                          std::uint32_t pass, std::uint32_t pixel) {
    return Uploaded(context, compiler, scene).session().followPixel(pixel, pass);
}

RecordedPath inspectPhoton(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                           std::uint32_t pass, const PhotonChoice& photon) {
    return Uploaded(context, compiler, scene).session().followPhoton(photon, pass);
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
