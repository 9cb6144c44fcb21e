// Renders a scene that changes: what a change does not touch (kernels, hierarchies, tables) stays on the device, and
// the first picture after it is a small one.
#pragma once

#include "live/debug_prints.h"
#include "live/dispatch_guard.h"
#include "live/reloading_compiler.h"
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

// What the page asks for, over what the scene file says.
struct View {
    std::vector<std::pair<std::string, std::string>> settings; // keys of the scene file and values, e.g. render.photons
    std::string shown = "picture";            // or global_map, caustic_map, photons, radius, normals, depth, bounces
    std::uint32_t debugPixel = shared::kNone; // y * width + x
};

class LiveRenderer {
public:
    // References are kept; the compiler is told of the scene's own code.
    LiveRenderer(const gpu::Context& context, ReloadingCompiler& compiler, Pulse& pulse,
                 std::function<bool()> isUnwanted);

    // Reads the scene file and uploads it. Throws Error, and then what was there stays.
    void load(const std::filesystem::path& file, const reference::TwinSources& twins);
    [[nodiscard]] bool isLoaded() const { return loaded_ != nullptr; }

    // Throws Error(WrongUsage) where a setting is refused, and then the former view stays.
    void look(View view);
    void lookAtPixel(std::uint32_t pixel) { view_.debugPixel = pixel; }
    [[nodiscard]] const Scene& scene() const { return scene_; } // with the settings
    [[nodiscard]] const View& view() const { return view_; }

    // These kernels are made anew for the next picture.
    void forget(const std::set<std::string>& kernels);

    // Begins a picture, small for the first look or at its full size.
    void begin(bool isPreview);
    [[nodiscard]] bool wantsPreview() const;
    void renderPass(); // throws Interrupted
    [[nodiscard]] bool isDone() const;
    void drop(); // the picture begun

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

    // Both sides of a pixel's path in the first pass, at full size.
    [[nodiscard]] parity::RecordedPath inspect(std::uint32_t pixel);

    [[nodiscard]] DebugPrints::Prints takePrints() { return prints_.take(); }

private:
    struct Loaded { // stays where it is: integrators hold references
        Scene scene;
        render::DeviceScene device;
    };
    struct Run {
        Scene scene;
        std::optional<render::Film> film;
        std::unique_ptr<render::PassIntegrator> integrator;
        std::uint32_t passes = 0;
        bool isPreview = false;
    };
    [[nodiscard]] Scene withView(const Scene& scene, const View& view) const;
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
    Scene scene_;
    std::unique_ptr<Run> run_;
    double previewPixels_ = 128.0 * 96.0; // what a first picture may have, by how long the last took
    std::map<std::string, gpu::StageTime> timesBefore_;
    std::map<std::string, gpu::StageTime> timesOfPass_;
};

} // namespace hyalite::live
