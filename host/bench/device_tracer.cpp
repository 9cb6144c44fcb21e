#include "bench/device_tracer.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <limits>

namespace hyalite::bench {

// The rays stand in the order in which a render takes them already.
constexpr std::uint32_t kInOrder = 0;

DeviceTracer::DeviceTracer(render::Device& device, const render::DeviceScene& deviceScene)
    : device_(device), deviceScene_(deviceScene),
      traceClosest_(device.kernel("trace_closest", deviceScene.specialization)),
      traceShadow_(device.kernel("trace_shadow", deviceScene.specialization)) {}

void DeviceTracer::load(const RaySet& set) {
    shadow_ = set.shadow;
    rays_ = {device_.context, std::span<const shared::Ray>(set.rays), "measured rays"};
    hits_ = {device_.context, shadow_ ? 0 : set.rays.size(), "measured hits"};
    const std::vector<glm::vec3> ones(shadow_ ? set.rays.size() : 0, glm::vec3(1));
    contributions_ = {device_.context, std::span<const glm::vec3>(ones), "measured contributions"};
    direct_ = {device_.context, ones.size(), "measured light"};
    device_.commands.clear(direct_.buffer());
    device_.commands.finish();
}

void DeviceTracer::trace() {
    const auto count = static_cast<std::uint32_t>(rays_.count());
    if (shadow_) {
        device_.commands.run(traceShadow_,
                             shared::TraceShadowArguments{.shadowRays = rays_,
                                                          .contributions = contributions_,
                                                          .direct = direct_,
                                                          .count = count,
                                                          .rootNode = deviceScene_.rootNode,
                                                          .width = kInOrder,
                                                          .live = {},
                                                          .rayCount = {},
                                                          .paths = {},
                                                          .visiblePoints = {},
                                                          .materials = {},
                                                          .normals = {},
                                                          .instances = {}},
                             count);
    } else {
        device_.commands.run(traceClosest_,
                             shared::TraceClosestArguments{.rays = rays_,
                                                           .hits = hits_,
                                                           .count = count,
                                                           .rootNode = deviceScene_.rootNode,
                                                           .width = kInOrder,
                                                           .live = {}},
                             count);
    }
    device_.commands.finish();
}

std::vector<float> DeviceTracer::ends() const {
    constexpr float kNothing = std::numeric_limits<float>::infinity();
    std::vector<float> ends;
    for (const glm::vec3& direct : direct_.read()) {
        ends.push_back(direct.x > 0 ? kNothing : 0);
    }
    for (const shared::Hit& hit : hits_.read()) {
        ends.push_back(hit.object == shared::kNone ? kNothing : hit.t);
    }
    return ends;
}

} // namespace hyalite::bench
