// Unidirectional path tracing with next-event estimation [Kajiya86], the unbiased yardstick of the other integrators.
#pragma once

#include "render/film/film.h"
#include "render/integrators/integrator.h"
#include "render/wavefront/camera_paths.h"
#include "render/wavefront/light_sampler.h"

namespace hyalite::render {

class PathTracing final : public PassIntegrator {
public:
    // The layers of its film.
    [[nodiscard]] static std::vector<LayerKind> layers() { return {{"met"}, {"sampled"}}; }

    // References are kept.
    PathTracing(Device& device, const Scene& scene, const DeviceScene& deviceScene, const Film& film);

    void renderPass(std::uint32_t pass) override;

private:
    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    const Film& film_;
    CameraPaths cameraPaths_;
    LightSampler lightSampler_;
    gpu::Kernel bouncePaths_;

    gpu::Array<shared::VisiblePoint> visiblePoints_; // where each pixel's path last met a diffuse surface
    gpu::Array<glm::vec3> met_;                      // light that paths met by themselves
    gpu::Array<glm::vec3> sampled_;                  // light that shadow rays brought
};

} // namespace hyalite::render
