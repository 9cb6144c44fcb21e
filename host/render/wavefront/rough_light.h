// Direct light where camera paths leave by rough lobes.
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/device.h"
#include "render/wavefront/device_counter.h"

#include "shaders/shared/kernel_arguments.h"

#include <optional>

namespace hyalite::render {

class RoughLight {
public:
    // Keeps the references.
    RoughLight(Device& device, const DeviceScene& deviceScene);

    // Most points that `count` paths may leave: none in scenes without rough lobes.
    [[nodiscard]] std::uint32_t points(std::uint32_t count) const { return deviceScene_.hasRoughLobes ? count : 0; }

    // Records adding the direct light at the points that the paths have left to `direct`: from one light picked
    // by place (light = kNone), or from the light named. `rayCount`: a DeviceCounter, to which the shadow rays are
    // added. `sought`: see Film::sought; null: not noted.
    void sample(shared::RoughPointArray points, shared::ColorArray direct, const gpu::ThreadCount& paths,
                std::uint32_t light, std::uint32_t pass, shared::UintArray rayCount, shared::UintArray sought = {});

private:
    Device& device_;
    const DeviceScene& deviceScene_;
    std::optional<gpu::Kernel> sampleRoughLights_; // only in scenes with rough lobes
};

} // namespace hyalite::render
