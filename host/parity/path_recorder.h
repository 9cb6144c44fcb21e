// Writes down the paths that the device follows, vertex by vertex.
#pragma once

#include "parity/observed.h"
#include "parity/sides.h"
#include "parity/vertex.h"

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace hyalite::parity {

// How the photons of a sequence were emitted.
struct RecordedPass {
    reference::PhotonPass pass;
    std::uint32_t maxDepth = 0;
};

// Paths are written down of so many passes, and of the photons of so many sequences: those of more fill the memory.
inline constexpr std::uint32_t kRecordedPasses = 4;

class PathRecorder {
public:
    // A reference is kept. `onlyPixel`: of all paths, those of this pixel alone.
    explicit PathRecorder(const Sides& sides, std::optional<std::uint32_t> onlyPixel = {})
        : sides_(sides), onlyPixel_(onlyPixel) {}

    // Notes what a dispatch that has just run says of paths.
    void see(const Observed& dispatch);

    // Vertices in the order of their depth, those of equal depth in the order of the queue.
    [[nodiscard]] const std::map<PathKey, std::vector<DeviceVertex>>& paths() const { return paths_; }
    [[nodiscard]] const std::map<std::uint32_t, RecordedPass>& photonPasses() const { return photonPasses_; }

private:
    // A camera path at its hit, and the rays that go on from there.
    struct Shaded {
        const shared::Ray& ray;
        const shared::Hit& hit;
        const shared::CameraPath& path;
        const shared::VisiblePoint& visible;
        std::span<const shared::Ray> next;
    };

    void seeShading(const Observed& dispatch);
    void seeTree(const Observed& dispatch);
    void addVertex(const Shaded& shaded, std::uint32_t depth, std::uint32_t pass);
    void seeBounces(const Observed& dispatch);
    void seeEmission(const Observed& dispatch);
    void seeScattering(const Observed& dispatch);

    [[nodiscard]] bool leavesOut(std::uint32_t pixel) const { return onlyPixel_ && *onlyPixel_ != pixel; }

    const Sides& sides_;
    std::optional<std::uint32_t> onlyPixel_;
    bool fromCamera_ = false;        // the camera queue holds paths that begin at the camera
    std::uint32_t cameraPasses_ = 0; // begun
    std::map<PathKey, std::vector<DeviceVertex>> paths_;
    std::map<std::uint32_t, RecordedPass> photonPasses_;
};

} // namespace hyalite::parity
