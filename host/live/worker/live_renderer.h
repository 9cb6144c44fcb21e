// Renders a scene that changes. What a change does not touch (kernels, hierarchies, tables) stays on the device, and
// the first picture after a change is a small preview.
#pragma once

#include "live/worker/debug_prints.h"
#include "live/worker/dispatch_guard.h"
#include "live/worker/reloading_compiler.h"
#include "parity/path_comparison.h"
#include "reference/bsdf/custom_twins.h"
#include "render/debug/debug_view.h"
#include "render/renderer.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hyalite::live {

// What the page asks for, beyond the scene file.
struct View {
    std::vector<std::pair<std::string, std::string>> settings; // keys of the scene file and values, e.g. render.photons
    std::string shown = "picture";            // or global_map, caustic_map, photons, radius, normals, depth, bounces
    std::uint32_t debugPixel = shared::kNone; // y * width + x
};

class LiveRenderer {
public:
    // References are kept. The compiler gets the scene's own code.
    LiveRenderer(const gpu::Context& context, ReloadingCompiler& compiler, Pulse& pulse,
                 std::function<bool()> isUnwanted);

    // Reads the scene file and uploads the scene; `twins`: of its own GLSL. When it throws Error, the former scene
    // stays.
    void load(const std::filesystem::path& file, const reference::TwinSources& twins);
    [[nodiscard]] bool isLoaded() const { return loaded_ != nullptr; }

    // Names of files in settings are relative to the scene file's folder. Throws Error(WrongUsage) when a setting is
    // refused; the former view stays.
    void look(View view);
    void lookAtPixel(std::uint32_t pixel) { view_.debugPixel = pixel; }
    [[nodiscard]] const Scene& scene() const { return scene_; } // with the settings
    [[nodiscard]] const View& view() const { return view_; }

    // Rebuilds these kernels for the next picture.
    void forget(const std::set<std::string>& kernels);

    // Begins a picture, as a small preview or at its full size.
    void begin(bool isPreview);
    [[nodiscard]] bool wantsPreview() const;
    void renderPass(); // throws Interrupted when the pass is not wanted any more
    [[nodiscard]] bool isDone() const;
    [[nodiscard]] bool isPreview() const { return run_ != nullptr && run_->isPreview; }
    void drop(); // gives up the picture that was begun

    struct Frame {
        LayeredImage image;
        bool isPreview = false;
        std::uint32_t passes = 0;
        std::uint32_t ofPasses = 0;
        std::optional<double> error;
        std::map<std::string, gpu::StageTime> stages; // of the last pass
        render::Counts counts;
        render::RenderNotes notes;
    };
    [[nodiscard]] Frame frame();

    // A pixel's path in the first pass at full size, on the device and in the reference. Throws Error.
    [[nodiscard]] parity::RecordedPath inspect(std::uint32_t pixel);

    [[nodiscard]] DebugPrints::Prints takePrints() { return prints_.take(); }

private:
    struct Loaded { // never moves: integrators hold references to it
        Scene scene;
        std::filesystem::path folder; // of the scene file
        render::DeviceScene device;
    };
    struct Run {
        Scene scene;
        std::optional<render::Film> film;
        std::unique_ptr<render::PassIntegrator> integrator;
        std::uint32_t passes = 0;
        bool isPreview = false;
    };
    void show(Scene seen, bool isNew); // renders this scene from now on
    [[nodiscard]] static Scene withView(const Loaded& loaded, const View& view);
    // Gives the compiler the scene's own code, and forgets the kernels that it changes.
    void useCodeOf(const Scene& scene);
    [[nodiscard]] std::unique_ptr<Run> makeRun(Scene scene, std::optional<render::DebugQuantity> quantity,
                                               bool isPreview);
    void adaptPreview(double seconds);

    const gpu::Context& context_;
    ReloadingCompiler& compiler_;
    Pulse& pulse_;
    render::Device device_;
    DebugPrints prints_;
    DispatchGuard guard_;
    gpu::Observation observation_; // the guard's
    std::unique_ptr<Loaded> loaded_;
    View view_;
    Scene scene_;                             // with the view's settings
    std::vector<Warning> lightWarnings_;      // of scene_
    std::map<std::string, std::string> code_; // of scene_, as the compiler has it
    std::unique_ptr<Run> run_;
    double previewPixels_ = 128.0 * 96.0; // of the next preview, adapted to how long the last one took
    std::map<std::string, gpu::StageTime> timesBefore_;
    std::map<std::string, gpu::StageTime> timesOfPass_;
};

} // namespace hyalite::live
