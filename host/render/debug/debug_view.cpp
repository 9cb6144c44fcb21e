#include "render/debug/debug_view.h"

#include <algorithm>

namespace hyalite::render {

DebugView::DebugView(const IntegratorInput& input, DebugQuantity quantity)
    : device_(input.device), deviceScene_(input.deviceScene), film_(input.film), quantity_(quantity),
      cameraPaths_(device_, input.scene, deviceScene_, film_.pixelCount()),
      traceClosest_(device_.kernel("trace_closest", deviceScene_.specialization)),
      showSurface_(device_.kernel("show_surface", deviceScene_.specialization)),
      visiblePoints_(device_.context, film_.pixelCount(), "visible points"),
      emitted_(device_.context, film_.pixelCount(), "emitted light"),
      colors_(device_.context, film_.pixelCount(), "view") {}

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
                         shared::TraceClosestArguments{.rays = queue.rays,
                                                       .hits = queue.hits,
                                                       .count = queue.count,
                                                       .rootNode = deviceScene_.rootNode,
                                                       .width = deviceScene_.widthOf(queue.count)},
                         queue.count);
    const std::uint32_t shown = quantity_ == DebugQuantity::Depth ? shared::kShowDepth : shared::kShowNormals;
    device_.commands.run(showSurface_,
                         shared::ShowSurfaceArguments{.rays = queue.rays,
                                                      .hits = queue.hits,
                                                      .normals = deviceScene_.normals,
                                                      .instances = deviceScene_.instances,
                                                      .colors = colors_,
                                                      .count = queue.count,
                                                      .shown = shown},
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
