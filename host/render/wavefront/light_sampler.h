// Direct light at visible points: samples a point on a light for each, and traces a shadow ray to it.
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/device_counter.h"
#include "render/wavefront/path_queue.h"

#include "shaders/shared/path_records.h"

namespace hyalite::render {

class LightSampler {
public:
    // Keeps the references. `capacity`: most visible points. `sought`: see Film::sought; null: not noted.
    LightSampler(Device& device, const DeviceScene& deviceScene, std::uint32_t capacity, shared::UintArray sought);

    // Samples a point on `light` (kNone: on one picked by place) for each visible point; points beyond maxDepth
    // segments are not sampled.
    void sample(const gpu::Array<shared::VisiblePoint>& visiblePoints, std::uint32_t light, std::uint32_t pass,
                std::uint32_t maxDepth);
    // Adds the light of the unoccluded samples.
    void trace(const gpu::Array<glm::vec3>& direct);

    // The same for the queue's paths that have reached a diffuse surface `depth` segments from the camera, from which
    // they continue: see SampleLightsArguments::bounceDepth.
    void sample(const gpu::Array<shared::VisiblePoint>& visiblePoints, const CameraQueue& queue, std::uint32_t pass,
                std::uint32_t maxDepth, std::uint32_t depth);
    void trace(const gpu::Array<glm::vec3>& direct, const CameraQueue& queue);

    [[nodiscard]] const gpu::Array<shared::Ray>& shadowRays() const { return shadowRays_; }
    [[nodiscard]] const gpu::Array<glm::vec3>& contributions() const { return contributions_; }

    // Number of rays so far. No command may be in flight.
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
    shared::UintArray sought_;
    gpu::Kernel sampleLights_;
    gpu::Kernel traceShadow_;
    gpu::Array<shared::Ray> shadowRays_;
    gpu::Array<glm::vec3> contributions_;
    shared::VisiblePointArray visiblePoints_; // of the last sampling
    DeviceCounter rayCount_;
};

} // namespace hyalite::render
