// Light that comes straight from the lights to where camera paths leave by rough lobes.
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/device.h"
#include "render/wavefront/device_counter.h"

#include "shaders/shared/kernel_arguments.h"

#include <optional>

namespace hyalite::render {

class RoughLight {
public:
    // References are kept.
    RoughLight(Device& device, const DeviceScene& deviceScene);

    // How many points `count` paths may leave: none in scenes without rough lobes.
    [[nodiscard]] std::uint32_t points(std::uint32_t count) const { return deviceScene_.hasRoughLobes ? count : 0; }

    // Records that `direct` gets what reaches the points which the paths have left: from one light picked in
    // proportion to power (light = kNone), or from the light named. `rayCount`: a DeviceCounter, to which the shadow
    // rays are added.
    void sample(shared::RoughPointArray points, shared::ColorArray direct, const gpu::ThreadCount& paths,
                std::uint32_t light, std::uint32_t pass, shared::UintArray rayCount);

private:
    Device& device_;
    const DeviceScene& deviceScene_;
    std::optional<gpu::Kernel> sampleRoughLights_; // of scenes with rough lobes
};

} // namespace hyalite::render
