// Direct light at visible points: a point on a light for each, and a shadow ray to it.
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/device_counter.h"
#include "render/wavefront/path_queue.h"

#include "shaders/shared/path_records.h"

namespace hyalite::render {

class LightSampler {
public:
    // References are kept. `capacity`: visible points at most.
    LightSampler(Device& device, const DeviceScene& deviceScene, std::uint32_t capacity);

    // Chooses a point on `light` (kNone: on one picked in proportion to its share of the photons) for each of the
    // visible points; segments beyond maxDepth are not sampled.
    void sample(const gpu::Array<shared::VisiblePoint>& visiblePoints, std::uint32_t light, std::uint32_t pass,
                std::uint32_t maxDepth);
    // Adds what the sampled lights send wherever nothing stands in the way.
    void trace(const gpu::Array<glm::vec3>& direct);

    // The same for the paths of the queue that have met a diffuse surface `depth` segments from the camera, from which
    // they go on: see SampleLightsArguments::bounceDepth.
    void sample(const gpu::Array<shared::VisiblePoint>& visiblePoints, const CameraQueue& queue, std::uint32_t pass,
                std::uint32_t maxDepth, std::uint32_t depth);
    void trace(const gpu::Array<glm::vec3>& direct, const CameraQueue& queue);

    [[nodiscard]] const gpu::Array<shared::Ray>& shadowRays() const { return shadowRays_; }
    [[nodiscard]] const gpu::Array<glm::vec3>& contributions() const { return contributions_; }

    // So far. No command may be in flight.
    [[nodiscard]] std::uint64_t raysTraced() const { return rayCount_.read(); }

private:
    struct Sampling {
        gpu::ThreadCount threads;
        shared::CameraPathArray paths; // of the queue, or none
        std::uint32_t light;
        std::uint32_t pass;
        std::uint32_t maxDepth;
        std::uint32_t bounceDepth = 0;
    };
    void record(const gpu::Array<shared::VisiblePoint>& visiblePoints, const Sampling& sampling);
    void record(const gpu::Array<glm::vec3>& direct, const gpu::ThreadCount& threads, shared::CameraPathArray paths);

    Device& device_;
    const DeviceScene& deviceScene_;
    gpu::Kernel sampleLights_;
    gpu::Kernel traceShadow_;
    gpu::Array<shared::Ray> shadowRays_;
    gpu::Array<glm::vec3> contributions_;
    DeviceCounter rayCount_;
};

} // namespace hyalite::render
