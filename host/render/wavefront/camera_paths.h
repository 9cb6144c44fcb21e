// Camera paths, followed through mirrors and glass to each pixel's first diffuse surface, or continued beyond it.
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/device_counter.h"
#include "render/wavefront/path_queue.h"
#include "render/wavefront/rough_light.h"

#include <functional>

namespace hyalite::render {

// Numbers of rays traced so far.
struct RaysTraced {
    std::uint64_t camera = 0;
    std::uint64_t gathering = 0; // part of these: paths from start()
    std::uint64_t shadow = 0;    // at rough surfaces
};

// What happens to a camera path at a diffuse surface.
enum class AtDiffuse { Ends, Bounces };

class CameraPaths {
public:
    // Keeps the references. `capacity`: paths in flight, one per pixel. `sought`: see Film::sought; null: not noted.
    CameraPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t capacity,
                shared::UintArray sought = {}, AtDiffuse atDiffuse = AtDiffuse::Ends);

    // The queue where paths start: one ray and one path per pixel, or any that a kernel writes here.
    [[nodiscard]] CameraQueue& queue() { return queue_; }

    // Fills the queue with a pass's rays through the lens.
    void generate(std::uint32_t pass) { generate(pass, deviceScene_.camera); }
    // The same for another camera, of as many pixels as there may be paths.
    void generate(std::uint32_t pass, const shared::CameraRecord& camera);

    // Fills the queue with the first `slots` next rays that are alive, in order.
    void start(std::uint32_t slots);

    // Called when the paths have reached their hits `depth` segments from the camera; may continue paths that end
    // there.
    using AtHits = std::function<void(std::uint32_t depth)>;

    // Follows the queue's paths. Writes, per pixel, where its path last hit a diffuse surface, and the emission on the
    // way [W/(m^2 sr)]; pixels without a path in the queue are unchanged. Adds the direct light on rough surfaces on
    // the way to `direct`, unless it is nullptr. Waits for the device only after every kBouncesAhead bounces.
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
    shared::UintArray sought_;
    gpu::Kernel generateCameraRays_;
    gpu::Kernel traceClosest_;
    gpu::Kernel shadeSurface_;
    Compaction compaction_;
    CameraQueue queue_;
    RoughLight roughLight_;
    gpu::Array<shared::RoughPoint> roughPoints_; // empty in scenes without rough lobes
    bool fromLens_ = true;                       // whether the queue's paths start at the lens
    DeviceCounter lensRays_;                     // camera rays and the rays that continue them
    DeviceCounter gatheringRays_;
    DeviceCounter shadowRays_;
};

} // namespace hyalite::render
