#include "render/wavefront/rough_light.h"

namespace hyalite::render {

RoughLight::RoughLight(Device& device, const DeviceScene& deviceScene) : device_(device), deviceScene_(deviceScene) {
    if (deviceScene.hasRoughLobes) {
        sampleRoughLights_ = device.kernel("sample_rough_lights", deviceScene.specialization);
    }
}

std::uint32_t RoughLight::sample(shared::RoughPointArray points, shared::ColorArray direct, std::uint32_t count,
                                 std::uint32_t light, std::uint32_t pass) const {
    if (!sampleRoughLights_) {
        return 0;
    }
    device_.commands.run(*sampleRoughLights_,
                         shared::SampleRoughLightsArguments{points, deviceScene_.materials, deviceScene_.lights, direct,
                                                            count, deviceScene_.lightCount, light, pass,
                                                            deviceScene_.rootNode},
                         count);
    return count;
}

} // namespace hyalite::render
