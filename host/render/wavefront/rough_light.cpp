#include "render/wavefront/rough_light.h"

namespace hyalite::render {

RoughLight::RoughLight(Device& device, const DeviceScene& deviceScene) : device_(device), deviceScene_(deviceScene) {
    if (deviceScene.hasRoughLobes) {
        sampleRoughLights_ = device.kernel("sample_rough_lights", deviceScene.specialization);
    }
}

void RoughLight::sample(shared::RoughPointArray points, shared::ColorArray direct, const gpu::ThreadCount& paths,
                        std::uint32_t light, std::uint32_t pass, shared::UintArray rayCount, shared::UintArray sought) {
    if (!sampleRoughLights_) {
        return;
    }
    device_.commands.run(*sampleRoughLights_,
                         shared::SampleRoughLightsArguments{.roughPoints = points,
                                                            .materials = deviceScene_.materials,
                                                            .lights = deviceScene_.lights,
                                                            .direct = direct,
                                                            .count = paths.most(),
                                                            .light = light,
                                                            .pass = pass,
                                                            .rootNode = deviceScene_.rootNode,
                                                            .live = paths.live(),
                                                            .rayCount = rayCount,
                                                            .sought = sought,
                                                            .normals = deviceScene_.normals,
                                                            .instances = deviceScene_.instances},
                         paths);
}

} // namespace hyalite::render
