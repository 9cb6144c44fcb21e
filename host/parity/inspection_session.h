// Both sides of one scene: records the paths that the device follows while it renders, and follows the same paths in
// the reference, vertex by vertex. `hyalite parity`, `hyalite inspect` and the live page use it to inspect paths.
#pragma once

#include "gpu/dispatch_observer.h"
#include "parity/capture.h"
#include "parity/path_comparison.h"
#include "parity/sides.h"
#include "render/wavefront/device.h"

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace hyalite::parity {

struct PhotonChoice {
    std::uint32_t number = 0;
    bool isCaustic = false; // one of the photons aimed at specular objects, else one of the global map
};

class InspectionSession {
public:
    // `scene` as uploaded to `device`, with the camera of `deviceScene`. Keeps references: `scene` must outlive the
    // session, `device` and `deviceScene` every call that renders (followPixel, followPhoton).
    InspectionSession(render::Device& device, const Scene& scene, const render::DeviceScene& deviceScene);

    // The path of a pixel (y * width + x) or of a photon in pass number `pass`, on both sides. Renders that pass on the
    // device as far as the path needs it. Other observers of device.commands see its dispatches too; an exception they
    // throw ends the pass and leaves the session unchanged. Throws Error(WrongUsage) if code of the scene has no twin
    // or there is no such photon, and whatever rendering throws.
    [[nodiscard]] RecordedPath followPixel(std::uint32_t pixel, std::uint32_t pass);
    [[nodiscard]] RecordedPath followPhoton(const PhotonChoice& photon, std::uint32_t pass);

    // For the lifetime of the Observation, which the session must outlive: records all paths that the device renders,
    // and compares each dispatch of these kernels (empty: all kernels) with its twin.
    [[nodiscard]] gpu::Observation watch(std::set<std::string> stages);

    // Results of watch(): the comparisons in the order of their first dispatch (can be taken once); all paths on both
    // sides; one path.
    [[nodiscard]] std::vector<StageResult> takeStages();
    [[nodiscard]] PathResults comparePaths() const;
    [[nodiscard]] RecordedPath path(const PathKey& key) const;

private:
    // Renders one pass to record its paths of this kind and number.
    [[nodiscard]] PathRecorder record(bool isPhoton, std::uint32_t number, std::uint32_t pass);

    render::Device& device_;
    const Scene& scene_;
    const render::DeviceScene& deviceScene_;
    Sides sides_;
    std::unique_ptr<Capture> capture_; // set by watch()
};

} // namespace hyalite::parity
