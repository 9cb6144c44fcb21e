#include "render/wavefront/camera_paths.h"

#include "scene/model/render_seed.h"

#include <algorithm>

namespace hyalite::render {

namespace {

gpu::Specialization shading(const DeviceScene& deviceScene, AtDiffuse atDiffuse) {
    gpu::Specialization constants = deviceScene.specialization;
    constants["kDiffuseBounces"] = atDiffuse == AtDiffuse::Bounces ? 1 : 0;
    return constants;
}

} // namespace

CameraPaths::CameraPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t capacity,
                         shared::UintArray sought, AtDiffuse atDiffuse)
    : device_(device), scene_(scene), deviceScene_(deviceScene), sought_(sought),
      generateCameraRays_(device.kernel("generate_camera_rays")),
      traceClosest_(device.kernel("trace_closest", deviceScene.specialization)),
      shadeSurface_(device.kernel("shade_surface", shading(deviceScene, atDiffuse))), compaction_(device),
      queue_(device.context, capacity), roughLight_(device, deviceScene),
      roughPoints_(device.context, roughLight_.points(capacity), "rough points"),
      lensRays_(device.context, "count of camera rays"), gatheringRays_(device.context, "count of gathering rays"),
      shadowRays_(device.context, "count of shadow rays at rough surfaces") {}

void CameraPaths::generate(std::uint32_t pass, const shared::CameraRecord& camera) {
    fromLens_ = true;
    queue_.sizes.begin(device_, queue_.capacity());
    device_.commands.run(generateCameraRays_,
                         shared::GenerateCameraRaysArguments{.rays = queue_.rays,
                                                             .paths = queue_.paths,
                                                             .seed = renderSeed(scene_.render),
                                                             .camera = camera,
                                                             .count = queue_.capacity(),
                                                             .pass = pass},
                         queue_.capacity());
}

void CameraPaths::start(std::uint32_t slots) {
    fromLens_ = false;
    queue_.sizes.begin(device_, slots);
    compaction_.run(device_, queue_);
}

void CameraPaths::follow(std::uint32_t pass, const gpu::Array<shared::VisiblePoint>& visiblePoints,
                         const gpu::Array<glm::vec3>& emitted, const gpu::Array<glm::vec3>* direct,
                         const AtHits& atHits) {
    // No path continues after the last segment
    const std::uint32_t maxDepth = std::max(scene_.render.maxDepth, 1U);
    for (std::uint32_t depth = 1; depth <= maxDepth; ++depth) {
        if (looksAtQueue(device_, depth) && queue_.sizes.read(device_).count == 0) {
            break;
        }
        bounce(depth, pass, visiblePoints, emitted);
        if (direct != nullptr) {
            roughLight_.sample(roughPoints_, *direct, queue_.threads(), shared::kNone, pass, shadowRays_, sought_);
        }
        if (atHits) {
            atHits(depth);
        }
        compaction_.run(device_, queue_, fromLens_ ? lensRays_ : gatheringRays_);
    }
}

RaysTraced CameraPaths::raysTraced() const {
    const std::uint64_t gathering = gatheringRays_.read();
    return {.camera = lensRays_.read() + gathering, .gathering = gathering, .shadow = shadowRays_.read()};
}

void CameraPaths::bounce(std::uint32_t depth, std::uint32_t pass, const gpu::Array<shared::VisiblePoint>& visiblePoints,
                         const gpu::Array<glm::vec3>& emitted) {
    const gpu::ThreadCount threads = queue_.threads();
    const std::uint32_t width = deviceScene_.widthOf(threads.most());
    device_.commands.run(traceClosest_,
                         shared::TraceClosestArguments{.rays = queue_.rays,
                                                       .hits = queue_.hits,
                                                       .count = threads.most(),
                                                       .rootNode = deviceScene_.rootNode,
                                                       .width = width,
                                                       .live = threads.live()},
                         threads);
    device_.commands.run(shadeSurface_,
                         shared::ShadeSurfaceArguments{.rays = queue_.rays,
                                                       .hits = queue_.hits,
                                                       .paths = queue_.paths,
                                                       .materials = deviceScene_.materials,
                                                       .lights = deviceScene_.lights,
                                                       .normals = deviceScene_.normals,
                                                       .instances = deviceScene_.instances,
                                                       .visiblePoints = visiblePoints,
                                                       .emitted = emitted,
                                                       .nextRays = queue_.nextRays,
                                                       .nextPaths = queue_.nextPaths,
                                                       .alive = queue_.alive,
                                                       .count = threads.most(),
                                                       .depth = depth,
                                                       .maxDepth = scene_.render.maxDepth,
                                                       .pass = pass,
                                                       .roughPoints = roughPoints_,
                                                       .width = width,
                                                       .live = threads.live()},
                         threads);
}

} // namespace hyalite::render
