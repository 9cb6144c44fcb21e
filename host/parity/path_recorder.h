// The paths that the device follows, vertex by vertex, as the checks of its kernels report them (PathNote in check.h).
#pragma once

#include "parity/sides.h"
#include "parity/vertex.h"

#include "shaders/shared/path_records.h"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace hyalite::parity {

// How the photons of a sequence were emitted.
struct RecordedPass {
    reference::PhotonPass pass;
    std::uint32_t maxDepth = 0;
};

// Paths are recorded of the first passes, and of the photons of the first sequences: more would fill the memory.
inline constexpr std::uint32_t kRecordedPasses = 4;

class PathRecorder {
public:
    // A reference is kept. `only`: records the paths of this pixel and of the photon with this number alone.
    explicit PathRecorder(const Sides& sides, std::optional<std::uint32_t> only = {}) : sides_(sides), only_(only) {}

    // From here on, shaded paths are those of another pass that begins at the camera; or of rays that begin elsewhere.
    void beginCameraPass() { isRecording_ = ++cameraPasses_ <= kRecordedPasses; }
    void leaveCamera() { isRecording_ = false; }

    // A camera path at its hit, and the rays that go on from there.
    struct Shaded {
        const shared::Ray& ray;
        const shared::Hit& hit;
        const shared::CameraPath& path;
        const shared::VisiblePoint& visible;
        std::span<const shared::Ray> next;
    };
    void addShading(const Shaded& shaded, std::uint32_t depth, std::uint32_t pass);
    // The path of this pixel goes on from the diffuse surface that it came to last.
    void addBounce(std::uint32_t pass, std::uint32_t pixel);
    // Has a camera path come to a diffuse surface and not gone on?
    [[nodiscard]] bool hasEnded(const PathKey& key) const;

    void beginPhotonPass(const reference::PhotonPass& pass);
    // What the scattering of this sequence's photons adds to what is known of it. False: they are not recorded.
    [[nodiscard]] bool setPhotonPass(std::uint32_t sequence, std::uint32_t kinds, std::uint32_t maxDepth);

    // A photon path at its hit.
    struct Scattered {
        const shared::Ray& ray;
        const shared::Hit& hit;
        const shared::PhotonPath& path;
        bool isStored;
        const shared::Ray* next; // nullptr: it ends here
    };
    void addScattering(const Scattered& scattered, std::uint32_t depth, std::uint32_t sequence);

    // Vertices in the order of their depth, those of equal depth in the order of the queue.
    [[nodiscard]] const std::map<PathKey, std::vector<DeviceVertex>>& paths() const { return paths_; }
    [[nodiscard]] const std::map<std::uint32_t, RecordedPass>& photonPasses() const { return photonPasses_; }

private:
    [[nodiscard]] bool leavesOut(std::uint32_t number) const { return only_ && *only_ != number; }

    const Sides& sides_;
    std::optional<std::uint32_t> only_;
    bool isRecording_ = false;       // shaded paths begin at the camera, and in one of the first passes
    std::uint32_t cameraPasses_ = 0; // begun
    std::map<PathKey, std::vector<DeviceVertex>> paths_;
    std::map<std::uint32_t, RecordedPass> photonPasses_;
};

} // namespace hyalite::parity
