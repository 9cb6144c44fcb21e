#include "render/wavefront/light_sampler.h"

#include "render/wavefront/device.h"
#include "shaders/shared/kernel_arguments.h"

namespace hyalite::render {

LightSampler::LightSampler(Device& device, const DeviceScene& deviceScene, std::uint32_t capacity,
                           shared::UintArray sought)
    : device_(device), deviceScene_(deviceScene), sought_(sought),
      sampleLights_(device.kernel("sample_lights", deviceScene.specialization)),
      traceShadow_(device.kernel("trace_shadow", deviceScene.specialization)),
      shadowRays_(device.context, capacity, "shadow rays"),
      contributions_(device.context, capacity, "light contributions"),
      rayCount_(device.context, "count of shadow rays") {}

void LightSampler::sample(const gpu::Array<shared::VisiblePoint>& visiblePoints, std::uint32_t light,
                          std::uint32_t pass, std::uint32_t maxDepth) {
    const auto count = static_cast<std::uint32_t>(shadowRays_.count());
    record(visiblePoints, {.threads = count, .paths = {}, .light = light, .pass = pass, .maxDepth = maxDepth});
}

void LightSampler::sample(const gpu::Array<shared::VisiblePoint>& visiblePoints, const CameraQueue& queue,
                          std::uint32_t pass, std::uint32_t maxDepth, std::uint32_t depth) {
    record(visiblePoints, {.threads = queue.threads(),
                           .paths = queue.paths,
                           .light = shared::kNone,
                           .pass = pass,
                           .maxDepth = maxDepth,
                           .bounceDepth = depth});
}

void LightSampler::record(const gpu::Array<shared::VisiblePoint>& visiblePoints, const Sampling& sampling) {
    const std::uint32_t most = sampling.threads.most();
    visiblePoints_ = visiblePoints;
    device_.commands.run(sampleLights_,
                         shared::SampleLightsArguments{.visiblePoints = visiblePoints,
                                                       .materials = deviceScene_.materials,
                                                       .lights = deviceScene_.lights,
                                                       .shadowRays = shadowRays_,
                                                       .contributions = contributions_,
                                                       .count = most,
                                                       .light = sampling.light,
                                                       .pass = sampling.pass,
                                                       .maxDepth = sampling.maxDepth,
                                                       .bounceDepth = sampling.bounceDepth,
                                                       .width = deviceScene_.widthOf(most),
                                                       .live = sampling.threads.live(),
                                                       .paths = sampling.paths,
                                                       .sought = sought_},
                         sampling.threads);
}

void LightSampler::trace(const gpu::Array<glm::vec3>& direct) {
    record(direct, static_cast<std::uint32_t>(shadowRays_.count()), {});
}

void LightSampler::trace(const gpu::Array<glm::vec3>& direct, const CameraQueue& queue) {
    record(direct, queue.threads(), queue.paths);
}

void LightSampler::record(const gpu::Array<glm::vec3>& direct, const gpu::ThreadCount& threads,
                          shared::CameraPathArray paths) {
    device_.commands.run(traceShadow_,
                         shared::TraceShadowArguments{.shadowRays = shadowRays_,
                                                      .contributions = contributions_,
                                                      .direct = direct,
                                                      .count = threads.most(),
                                                      .rootNode = deviceScene_.rootNode,
                                                      .width = deviceScene_.widthOf(threads.most()),
                                                      .live = threads.live(),
                                                      .rayCount = rayCount_,
                                                      .paths = paths,
                                                      .visiblePoints = visiblePoints_,
                                                      .materials = deviceScene_.materials,
                                                      .normals = deviceScene_.normals,
                                                      .instances = deviceScene_.instances},
                         threads);
}

} // namespace hyalite::render
