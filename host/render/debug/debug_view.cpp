#include "render/debug/debug_view.h"

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
    const std::uint32_t count = queue.capacity();
    device_.commands.run(traceClosest_,
                         shared::TraceClosestArguments{.rays = queue.rays,
                                                       .hits = queue.hits,
                                                       .count = count,
                                                       .rootNode = deviceScene_.rootNode,
                                                       .width = deviceScene_.widthOf(count),
                                                       .live = {}},
                         count);
    const std::uint32_t shown = quantity_ == DebugQuantity::Depth ? shared::kShowDepth : shared::kShowNormals;
    device_.commands.run(showSurface_,
                         shared::ShowSurfaceArguments{.rays = queue.rays,
                                                      .hits = queue.hits,
                                                      .normals = deviceScene_.normals,
                                                      .instances = deviceScene_.instances,
                                                      .colors = colors_,
                                                      .count = count,
                                                      .shown = shown},
                         count);
    counts_[Counter::CameraRays] += count;
}

void DebugView::countSegments(std::uint32_t pass) {
    cameraPaths_.follow(pass, visiblePoints_, emitted_, nullptr);
    device_.commands.finish();
    counts_[Counter::CameraRays] = cameraPaths_.raysTraced().camera;
    std::vector<glm::vec3> colors;
    for (const shared::VisiblePoint& point : visiblePoints_.read()) {
        colors.emplace_back(static_cast<float>(point.depth));
    }
    colors_.write(colors);
}

} // namespace hyalite::render
