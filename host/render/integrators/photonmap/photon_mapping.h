// Photon mapping in two passes [Jensen96, Jensen01]: photons from the lights into maps, then rays from the eye that ask
// the maps what they do not compute themselves.
#pragma once

#include "render/integrators/integrator.h"
#include "render/photons/photon_maps.h"
#include "render/wavefront/camera_paths.h"
#include "render/wavefront/light_sampler.h"

namespace hyalite::render {

class PhotonMapping final : public PassIntegrator {
public:
    [[nodiscard]] static IntegratorKind kind();

    explicit PhotonMapping(const IntegratorInput& input);

    // Makes the maps: of photons that it traces, or of those in a file.
    void begin() override;
    // One sample per pixel.
    void renderPass(std::uint32_t pass) override;

private:
    void noteMaps();
    void showRadii();
    void renderLight(std::uint32_t pass);
    void sampleDirectLight(std::uint32_t pass);
    void gatherIndirectLight(std::uint32_t pass);
    void drawPhotons();

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    Film& film_;
    PhotonFiles files_;

    CameraPaths cameraPaths_;
    LightSampler lightSampler_;
    PhotonMaps maps_;
    gpu::Kernel startGatherRays_;
    gpu::Kernel skipShadowRays_;
    gpu::Kernel addGatheredLight_;

    gpu::Array<shared::VisiblePoint> visiblePoints_;
    gpu::Array<shared::VisiblePoint> gatherPoints_; // where gathering rays end
    gpu::Array<glm::vec3> emitted_;
    gpu::Array<glm::vec3> unused_; // emission that gathering rays see: direct and caustic light has it already
    gpu::Array<glm::vec3> direct_;
    gpu::Array<glm::vec3> caustic_;
    gpu::Array<glm::vec3> indirect_;
    gpu::Array<glm::vec3> found_; // by the gathering rays
    gpu::Array<glm::vec3> points_;
    gpu::Array<float> radii_;
    gpu::Array<shared::uint> lit_;
    gpu::Array<shared::uint> shadowed_;
    DeviceCounter raysSaved_; // shadow rays that shadow photons spared
};

} // namespace hyalite::render
