// The paths that the device follows, vertex by vertex, as reported by the checks of its kernels (PathNote in check.h).
#pragma once

#include "parity/sides.h"
#include "parity/vertex.h"

#include "shaders/shared/path_records.h"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace hyalite::parity {

// Emission of the photons of one sequence.
struct RecordedPass {
    reference::PhotonPass pass;
    std::uint32_t maxDepth = 0;
};

// Records paths of the first passes, and photons of the first sequences: more would exhaust memory.
inline constexpr std::uint32_t kRecordedPasses = 4;

class PathRecorder {
public:
    // Keeps a reference. `only`: records only the paths of this pixel and of the photon with this number.
    explicit PathRecorder(const Sides& sides, std::optional<std::uint32_t> only = {}) : sides_(sides), only_(only) {}

    // From here on, shaded paths belong to a new pass from the camera (beginCameraPass), or to rays that start
    // elsewhere.
    void beginCameraPass() { isRecording_ = ++cameraPasses_ <= kRecordedPasses; }
    void leaveCamera() { isRecording_ = false; }

    // A camera path at its hit, and its next rays.
    struct Shaded {
        const shared::Ray& ray;
        const shared::Hit& hit;
        const shared::CameraPath& path;
        const shared::VisiblePoint& visible;
        std::span<const shared::Ray> next;
    };
    void addShading(const Shaded& shaded, std::uint32_t depth, std::uint32_t pass);
    // The path of this pixel continues from the diffuse surface that it reached last.
    void addBounce(std::uint32_t pass, std::uint32_t pixel);
    // True if the camera path ended on a diffuse surface.
    [[nodiscard]] bool hasEnded(const PathKey& key) const;

    void beginPhotonPass(const reference::PhotonPass& pass);
    // Adds what the scattering dispatch knows of this photon sequence. False: the sequence is not recorded.
    [[nodiscard]] bool setPhotonPass(std::uint32_t sequence, std::uint32_t kinds, std::uint32_t maxDepth);

    // A photon path at its hit.
    struct Scattered {
        const shared::Ray& ray;
        const shared::Hit& hit;
        const shared::PhotonPath& path;
        bool isStored;
        const shared::Ray* next; // nullptr: the path ends here
    };
    void addScattering(const Scattered& scattered, std::uint32_t depth, std::uint32_t sequence);

    // Vertices ordered by depth, at equal depth by queue position.
    [[nodiscard]] const std::map<PathKey, std::vector<DeviceVertex>>& paths() const { return paths_; }
    [[nodiscard]] const std::map<std::uint32_t, RecordedPass>& photonPasses() const { return photonPasses_; }

private:
    [[nodiscard]] bool leavesOut(std::uint32_t number) const { return only_ && *only_ != number; }

    const Sides& sides_;
    std::optional<std::uint32_t> only_;
    bool isRecording_ = false;       // shaded paths start at the camera, in one of the recorded passes
    std::uint32_t cameraPasses_ = 0; // begun
    std::map<PathKey, std::vector<DeviceVertex>> paths_;
    std::map<std::uint32_t, RecordedPass> photonPasses_;
};

} // namespace hyalite::parity
