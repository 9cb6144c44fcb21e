// Camera paths, followed through mirrors and glass to the first diffuse surface of each pixel, or on from there.
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/device_counter.h"
#include "render/wavefront/path_queue.h"
#include "render/wavefront/rough_light.h"

#include <functional>

namespace hyalite::render {

// Rays so far.
struct RaysTraced {
    std::uint64_t camera = 0;
    std::uint64_t gathering = 0; // of these, of paths that start() began
    std::uint64_t shadow = 0;    // at rough surfaces
};

// What a diffuse surface is to a camera path.
enum class AtDiffuse { Ends, Bounces };

class CameraPaths {
public:
    // References are kept. `capacity`: paths in flight, one per pixel.
    CameraPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t capacity,
                AtDiffuse atDiffuse = AtDiffuse::Ends);

    // Where paths start: one ray and one path per pixel, or any that a kernel writes here.
    [[nodiscard]] CameraQueue& queue() { return queue_; }

    // Fills the queue with the rays of a pass through the lens.
    void generate(std::uint32_t pass);

    // Fills the queue with those of the first `slots` next rays that are alive, in order.
    void start(std::uint32_t slots);

    // Called when the paths have come to their hits `depth` segments from the camera: may send those on that end there.
    using AtHits = std::function<void(std::uint32_t depth)>;

    // Follows what the queue holds. Per pixel: where its path last met a diffuse surface, and the emission on the way
    // [W/(m^2 sr)]; pixels without a path in the queue are left as they are. To `direct`, if it is not nullptr, is
    // added what comes straight from the lights to rough surfaces on the way. Waits for the device only after every
    // kBouncesAhead bounces.
    void follow(std::uint32_t pass, const gpu::Array<shared::VisiblePoint>& visiblePoints,
                const gpu::Array<glm::vec3>& emitted, const gpu::Array<glm::vec3>* direct, const AtHits& atHits = {});

    // No command may be in flight.
    [[nodiscard]] RaysTraced raysTraced() const;

private:
    void bounce(std::uint32_t depth, std::uint32_t pass, const gpu::Array<shared::VisiblePoint>& visiblePoints,
                const gpu::Array<glm::vec3>& emitted);

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    gpu::Kernel generateCameraRays_;
    gpu::Kernel traceClosest_;
    gpu::Kernel shadeSurface_;
    Compaction compaction_;
    CameraQueue queue_;
    RoughLight roughLight_;
    gpu::Array<shared::RoughPoint> roughPoints_; // none in scenes without rough lobes
    bool fromLens_ = true;                       // the paths in the queue
    DeviceCounter lensRays_;                     // with all that follows them
    DeviceCounter gatheringRays_;
    DeviceCounter shadowRays_;
};

} // namespace hyalite::render
