// Light that comes straight from the lights to where camera paths leave by rough lobes.
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/device.h"

#include "shaders/shared/kernel_arguments.h"

#include <optional>

namespace hyalite::render {

class RoughLight {
public:
    // References are kept.
    RoughLight(Device& device, const DeviceScene& deviceScene);

    // How many points `count` paths may leave: none in scenes without rough lobes.
    [[nodiscard]] std::uint32_t points(std::uint32_t count) const { return deviceScene_.hasRoughLobes ? count : 0; }

    // Adds to `direct` what reaches the points that shade_surface left of `count` paths: from one light picked in
    // proportion to power (light = kNone), or from the light named. Returns the number of shadow rays.
    [[nodiscard]] std::uint32_t sample(shared::RoughPointArray points, shared::ColorArray direct, std::uint32_t count,
                                       std::uint32_t light, std::uint32_t pass) const;

private:
    Device& device_;
    const DeviceScene& deviceScene_;
    std::optional<gpu::Kernel> sampleRoughLights_; // of scenes with rough lobes
};

} // namespace hyalite::render
