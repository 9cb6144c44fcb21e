// Direct light at visible points: a point on a light for each, and a shadow ray to it.
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/device.h"

#include "shaders/shared/path_records.h"

namespace hyalite::render {

class LightSampler {
public:
    // References are kept. `capacity`: visible points at most.
    LightSampler(Device& device, const DeviceScene& deviceScene, std::uint32_t capacity);

    // Chooses a point on `light` (kNone: on one picked in proportion to its share of the photons) for each of the
    // visible points; segments beyond maxDepth are not sampled. `bounceDepth`: see SampleLightsArguments.
    void sample(const gpu::Array<shared::VisiblePoint>& visiblePoints, std::uint32_t light, std::uint32_t pass,
                std::uint32_t maxDepth, std::uint32_t bounceDepth = 0);

    // Adds what the sampled lights send wherever nothing stands in the way.
    void trace(const gpu::Array<glm::vec3>& direct);

    [[nodiscard]] const gpu::Array<shared::Ray>& shadowRays() const { return shadowRays_; }
    [[nodiscard]] const gpu::Array<glm::vec3>& contributions() const { return contributions_; }

private:
    Device& device_;
    const DeviceScene& deviceScene_;
    gpu::Kernel sampleLights_;
    gpu::Kernel traceShadow_;
    gpu::Array<shared::Ray> shadowRays_;
    gpu::Array<glm::vec3> contributions_;
};

} // namespace hyalite::render
