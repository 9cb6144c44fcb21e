// Unidirectional path tracing with next-event estimation [Kajiya86], the unbiased reference for the other integrators.
#pragma once

#include "render/integrators/integrator.h"
#include "render/wavefront/camera_paths.h"
#include "render/wavefront/light_sampler.h"

namespace hyalite::render {

class PathTracing final : public PassIntegrator {
public:
    [[nodiscard]] static IntegratorKind kind();

    explicit PathTracing(const IntegratorInput& input);

    void renderPass(std::uint32_t pass) override;

private:
    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    Film& film_;
    CameraPaths cameraPaths_;
    LightSampler lightSampler_;
    gpu::Kernel bouncePaths_;

    gpu::Array<shared::VisiblePoint> visiblePoints_; // where each pixel's path last hit a diffuse surface
    gpu::Array<glm::vec3> met_;                      // light that paths hit themselves
    gpu::Array<glm::vec3> sampled_;                  // light from next-event estimation
};

} // namespace hyalite::render
