#include "render/wavefront/light_sampler.h"

#include "render/wavefront/device.h"
#include "shaders/shared/kernel_arguments.h"

namespace hyalite::render {

LightSampler::LightSampler(Device& device, const DeviceScene& deviceScene, std::uint32_t capacity)
    : device_(device), deviceScene_(deviceScene),
      sampleLights_(device.kernel("sample_lights", deviceScene.specialization)),
      traceShadow_(device.kernel("trace_shadow", deviceScene.specialization)),
      shadowRays_(device.context, capacity, "shadow rays"),
      contributions_(device.context, capacity, "light contributions") {}

void LightSampler::sample(const gpu::Array<shared::VisiblePoint>& visiblePoints, std::uint32_t light,
                          std::uint32_t pass, std::uint32_t maxDepth, std::uint32_t bounceDepth) {
    const auto count = static_cast<std::uint32_t>(shadowRays_.count());
    device_.commands.run(sampleLights_,
                         shared::SampleLightsArguments{visiblePoints, deviceScene_.materials, deviceScene_.lights,
                                                       shadowRays_, contributions_, count, deviceScene_.lightCount,
                                                       light, pass, maxDepth, bounceDepth, deviceScene_.widthOf(count)},
                         count);
}

void LightSampler::trace(const gpu::Array<glm::vec3>& direct) {
    const auto count = static_cast<std::uint32_t>(shadowRays_.count());
    device_.commands.run(traceShadow_,
                         shared::TraceShadowArguments{shadowRays_, contributions_, direct, count, deviceScene_.rootNode,
                                                      deviceScene_.widthOf(count)},
                         count);
}

} // namespace hyalite::render
