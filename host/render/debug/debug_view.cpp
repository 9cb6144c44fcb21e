#include "render/debug/debug_view.h"

#include <algorithm>

namespace hyalite::render {

DebugView::DebugView(Device& device, const Scene& scene, const DeviceScene& deviceScene, const Film& film,
                     DebugQuantity quantity)
    : device_(device), deviceScene_(deviceScene), film_(film), quantity_(quantity),
      cameraPaths_(device, scene, deviceScene, film.pixelCount()),
      traceClosest_(device.kernel("trace_closest", deviceScene.specialization)),
      showSurface_(device.kernel("show_surface", deviceScene.specialization)),
      visiblePoints_(device.context, film.pixelCount(), "visible points"),
      emitted_(device.context, film.pixelCount(), "emitted light"), colors_(device.context, film.pixelCount(), "view") {
}

void DebugView::renderPass(std::uint32_t pass) {
    cameraPaths_.generate(pass);
    if (quantity_ == DebugQuantity::Bounces) {
        countSegments(pass);
    } else {
        drawSurfaces();
    }
    film_.add(device_, 0, colors_);
    device_.commands.finish();
}

void DebugView::drawSurfaces() {
    const CameraQueue& queue = cameraPaths_.queue();
    device_.commands.run(traceClosest_,
                         shared::TraceClosestArguments{queue.rays, queue.hits, queue.count, deviceScene_.rootNode,
                                                       deviceScene_.widthOf(queue.count)},
                         queue.count);
    const std::uint32_t shown = quantity_ == DebugQuantity::Depth ? shared::kShowDepth : shared::kShowNormals;
    device_.commands.run(showSurface_,
                         shared::ShowSurfaceArguments{queue.rays, queue.hits, deviceScene_.normals,
                                                      deviceScene_.instances, colors_, queue.count, shown},
                         queue.count);
    counts_[Counter::CameraRays] += queue.count;
}

void DebugView::countSegments(std::uint32_t pass) {
    counts_[Counter::CameraRays] += cameraPaths_.follow(pass, visiblePoints_, emitted_, nullptr).camera;
    device_.commands.finish();
    std::ranges::transform(visiblePoints_.host(), colors_.host().begin(), [](const shared::VisiblePoint& point) {
        return glm::vec3(static_cast<float>(point.depth));
    });
}

} // namespace hyalite::render
