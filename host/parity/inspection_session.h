// Both sides of one scene: records the paths that the device follows while it renders, and follows the same paths in
// the reference, vertex by vertex. `hyalite parity`, `hyalite inspect` and the live page look at paths through this.
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
    bool isCaustic = false; // one of those aimed at what is specular, else of the global map
};

class InspectionSession {
public:
    // `scene` as it was uploaded to `device`, the camera of `deviceScene` included. References are kept: `scene` must
    // outlive the session, `device` and `deviceScene` every call that renders (followPixel, followPhoton).
    InspectionSession(render::Device& device, const Scene& scene, const render::DeviceScene& deviceScene);

    // The path of a pixel (y * width + x) or of a photon in pass number `pass`, on both sides. Renders that pass on the
    // device as far as the path needs it; other observers of device.commands see its dispatches too, and what they
    // throw ends it and leaves the session as it was. Throws Error(WrongUsage) where code of the scene has no twin or
    // there is no such photon, and what rendering throws.
    [[nodiscard]] RecordedPath followPixel(std::uint32_t pixel, std::uint32_t pass);
    [[nodiscard]] RecordedPath followPhoton(const PhotonChoice& photon, std::uint32_t pass);

    // While the Observation lives, and the session with it: records all paths of what the device renders, and compares
    // each dispatch of these kernels (none given: of all) with its twin.
    [[nodiscard]] gpu::Observation watch(std::set<std::string> stages);

    // Of what was watched: the comparisons in the order of their first dispatch, once; all paths on both sides; one.
    [[nodiscard]] std::vector<StageResult> takeStages();
    [[nodiscard]] PathResults comparePaths() const;
    [[nodiscard]] RecordedPath path(const PathKey& key) const;

private:
    // Renders one pass for the sake of its paths of this kind, and records those with this number.
    [[nodiscard]] PathRecorder record(bool isPhoton, std::uint32_t number, std::uint32_t pass);

    render::Device& device_;
    const Scene& scene_;
    const render::DeviceScene& deviceScene_;
    Sides sides_;
    std::unique_ptr<Capture> capture_; // what is watched
};

} // namespace hyalite::parity
