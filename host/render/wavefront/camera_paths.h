// Camera paths, followed through mirrors and glass to the first diffuse surface of each pixel, or on from there.
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/path_queue.h"
#include "render/wavefront/rough_light.h"

#include <functional>

namespace hyalite::render {

struct RaysTraced {
    std::uint64_t camera = 0;
    std::uint64_t shadow = 0; // at rough surfaces
};

// What a diffuse surface is to a camera path.
enum class AtDiffuse { Ends, Bounces };

class CameraPaths {
public:
    // References are kept. `capacity`: paths in flight, one per pixel.
    CameraPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t capacity,
                AtDiffuse atDiffuse = AtDiffuse::Ends);

    // Where paths start: one ray and one path per pixel, or any that a kernel writes here, the count included.
    [[nodiscard]] CameraQueue& queue() { return queue_; }

    // Fills the queue with the rays of a pass through the lens.
    void generate(std::uint32_t pass);

    // Puts the living among the first `slots` next rays into the queue, in order.
    void compact(std::uint32_t slots) { compaction_.run(device_, queue_, slots); }

    // Called when the paths have come to their hits `depth` segments from the camera: may send those on that end there.
    using AtHits = std::function<void(std::uint32_t depth)>;

    // Follows what the queue holds. Per pixel: where its path last met a diffuse surface, and the emission on the way
    // [W/(m^2 sr)]; pixels without a path in the queue are left as they are. To `direct`, if it is not nullptr, is
    // added what comes straight from the lights to rough surfaces on the way.
    RaysTraced follow(std::uint32_t pass, const gpu::Array<shared::VisiblePoint>& visiblePoints,
                      const gpu::Array<glm::vec3>& emitted, const gpu::Array<glm::vec3>* direct,
                      const AtHits& atHits = {});

private:
    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    gpu::Kernel generateCameraRays_;
    gpu::Kernel traceClosest_;
    gpu::Kernel shadeSurface_;
    CameraCompaction compaction_;
    CameraQueue queue_;
    RoughLight roughLight_;
    gpu::Array<shared::RoughPoint> roughPoints_; // none in scenes without rough lobes
};

} // namespace hyalite::render
