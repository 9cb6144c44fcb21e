#include "render/wavefront/camera_paths.h"

#include "scene/model/render_seed.h"

namespace hyalite::render {

namespace {

gpu::Specialization shading(const DeviceScene& deviceScene, AtDiffuse atDiffuse) {
    gpu::Specialization constants = deviceScene.specialization;
    constants["kDiffuseBounces"] = atDiffuse == AtDiffuse::Bounces ? 1 : 0;
    return constants;
}

} // namespace

CameraPaths::CameraPaths(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t capacity,
                         AtDiffuse atDiffuse)
    : device_(device), scene_(scene), deviceScene_(deviceScene),
      generateCameraRays_(device.kernel("generate_camera_rays")),
      traceClosest_(device.kernel("trace_closest", deviceScene.specialization)),
      shadeSurface_(device.kernel("shade_surface", shading(deviceScene, atDiffuse))), compaction_(device),
      queue_(device.context, capacity), roughLight_(device, deviceScene),
      roughPoints_(device.context, roughLight_.points(capacity), "rough points") {}

void CameraPaths::generate(std::uint32_t pass) {
    queue_.count = queue_.capacity();
    device_.commands.run(generateCameraRays_,
                         shared::GenerateCameraRaysArguments{queue_.rays, queue_.paths, renderSeed(scene_.render),
                                                             deviceScene_.camera, queue_.count, pass},
                         queue_.count);
}

RaysTraced CameraPaths::follow(std::uint32_t pass, const gpu::Array<shared::VisiblePoint>& visiblePoints,
                               const gpu::Array<glm::vec3>& emitted, const gpu::Array<glm::vec3>* direct,
                               const AtHits& atHits) {
    gpu::Commands& commands = device_.commands;
    CameraQueue& queue = queue_;
    RaysTraced rays;
    for (std::uint32_t depth = 1; queue.count > 0; ++depth) {
        const std::uint32_t width = deviceScene_.widthOf(queue.count);
        commands.run(traceClosest_,
                     shared::TraceClosestArguments{queue.rays, queue.hits, queue.count, deviceScene_.rootNode, width},
                     queue.count);
        commands.run(shadeSurface_,
                     shared::ShadeSurfaceArguments{queue.rays, queue.hits, queue.paths, deviceScene_.materials,
                                                   deviceScene_.lights, deviceScene_.normals, deviceScene_.instances,
                                                   visiblePoints, emitted, queue.nextRays, queue.nextPaths, queue.alive,
                                                   queue.count, depth, scene_.render.maxDepth, pass, roughPoints_,
                                                   width},
                     queue.count);
        rays.camera += queue.count;
        if (direct != nullptr) {
            rays.shadow += roughLight_.sample(roughPoints_, *direct, queue.count, shared::kNone, pass);
        }
        if (atHits) {
            atHits(depth);
        }
        compact(queue.count);
    }
    return rays;
}

} // namespace hyalite::render
