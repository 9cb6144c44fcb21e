#include "parity/inspection_session.h"

#include "base/error.h"
#include "parity/checks/checks.h"
#include "parity/observed.h"
#include "reference/bsdf/custom_twins.h"
#include "render/film/film.h"
#include "render/integrators/registry.h"
#include "scene/model/render_seed.h"

#include <optional>
#include <utility>

namespace hyalite::parity {

namespace {

// Thrown to end a pass once all paths of the requested kind have been recorded.
struct EndOfPass {};

// Records the paths of one pixel or photon, of one kind; copies buffers only for the dispatches that report on them.
class PathObserver final : public gpu::DispatchObserver {
public:
    PathObserver(const render::Device& device, PathRecorder& recorder, bool isPhoton)
        : device_(device), recorder_(recorder), isPhoton_(isPhoton) {}

    void before(const gpu::Dispatch& dispatch) override {
        const Check* check = checkOf(dispatch.kernel.name());
        if (check == nullptr || check->paths.take == nullptr) {
            return;
        }
        const PathNote& note = check->paths;
        const bool isSought = note.ofPhotons == isPhoton_;
        if (!isSought && note.begins && hasBegun_) {
            throw EndOfPass();
        }
        if (isSought) {
            hasBegun_ = hasBegun_ || note.begins;
            note_ = &note;
            seen_.emplace(device_.context, device_.tables, dispatch);
        }
    }
    void after(const gpu::Dispatch& /*dispatch*/) override {
        if (seen_) {
            note_->take(recorder_, *seen_);
            seen_.reset();
        }
    }

private:
    const render::Device& device_;
    PathRecorder& recorder_;
    bool isPhoton_;
    bool hasBegun_ = false;
    const PathNote* note_ = nullptr; // of the running dispatch
    std::optional<Observed> seen_;
};

} // namespace

InspectionSession::InspectionSession(render::Device& device, const Scene& scene, const render::DeviceScene& deviceScene)
    : device_(device), scene_(scene), deviceScene_(deviceScene), sides_(scene, deviceScene) {}

PathRecorder InspectionSession::record(bool isPhoton, std::uint32_t number, std::uint32_t pass) {
    if (const CustomCode* code = reference::codeWithoutTwin(scene_)) {
        throw reference::noTwin(*code);
    }
    Scene scene = scene_;
    scene.render.passes = 1;
    const render::IntegratorKind& kind = render::integratorKind(scene);
    if (kind.simplifyForPaths != nullptr) {
        kind.simplifyForPaths(scene.render);
    }
    PathRecorder recorder(sides_, number);
    PathObserver observer(device_, recorder, isPhoton);
    render::Film film(device_, scene.camera.resolution, kind.layers(scene.render));
    const auto integrator = kind.make({.device = device_, .scene = scene, .deviceScene = deviceScene_, .film = film});
    const gpu::FinishAtEnd finish(device_.commands);
    const gpu::Observation observation = device_.commands.observe(observer);
    try {
        integrator->prepare();
        integrator->begin();
        film.beginPass(pass);
        integrator->renderPass(pass);
        device_.commands.finish();
    } catch (const EndOfPass&) { // finished at the end of this scope
    }
    return recorder;
}

RecordedPath InspectionSession::followPixel(std::uint32_t pixel, std::uint32_t pass) {
    return pathOf(sides_, record(false, pixel, pass), {false, pass, pixel});
}

RecordedPath InspectionSession::followPhoton(const PhotonChoice& photon, std::uint32_t pass) {
    const PathRecorder recorder = record(true, photon.number, pass);
    const std::uint32_t purpose = photon.isCaustic ? shared::kCausticPhotons : shared::kGlobalPhotons;
    const bool areTracedOnce = render::integratorKind(scene_).keepsPhotons;
    const std::uint32_t sequence = shared::photonSequence(renderSeed(scene_.render), purpose, areTracedOnce ? 0 : pass);
    const auto& sent = recorder.photonPasses();
    const auto found = sent.find(sequence);
    if (found == sent.end()) {
        throw Error(ExitCode::WrongUsage,
                    photon.isCaustic ? "this render emits no caustic photons" : "this integrator emits no photons",
                    photon.isCaustic ? "leave --caustic out" : "ask for a pixel with --pixel X,Y");
    }
    if (photon.number >= found->second.pass.count) {
        throw Error(ExitCode::WrongUsage, "there is no photon " + std::to_string(photon.number) + " of " +
                                              std::to_string(found->second.pass.count));
    }
    return pathOf(sides_, recorder, {true, sequence, photon.number});
}

gpu::Observation InspectionSession::watch(std::set<std::string> stages) {
    capture_ = std::make_unique<Capture>(device_.context, device_.tables, sides_, std::move(stages));
    return device_.commands.observe(*capture_);
}

std::vector<StageResult> InspectionSession::takeStages() {
    return capture_->finish();
}

PathResults InspectionSession::comparePaths() const {
    return parity::comparePaths(sides_, capture_->recorder());
}

RecordedPath InspectionSession::path(const PathKey& key) const {
    return pathOf(sides_, capture_->recorder(), key);
}

} // namespace hyalite::parity
