// Photon mapping in two passes [Jensen96, Jensen01]: photons from the lights into maps, then rays from the eye that ask
// the maps what they do not compute themselves.
#pragma once

#include "render/film/film.h"
#include "render/integrators/integrator.h"
#include "render/photons/photon_maps.h"
#include "render/renderer.h"
#include "render/wavefront/camera_paths.h"
#include "render/wavefront/light_sampler.h"

#include <filesystem>

namespace hyalite::render {

class PhotonMapping final : public PassIntegrator {
public:
    // The layers of its film.
    [[nodiscard]] static std::vector<LayerKind> layers(PhotonView view);

    // References are kept.
    PhotonMapping(Device& device, const Scene& scene, const DeviceScene& deviceScene, const Film& film,
                  const RenderOptions& options);

    // The first call traces the photons; a pass is then one sample per pixel.
    void renderPass(std::uint32_t pass) override;

private:
    void prepareMaps();
    void noteMaps();
    void renderLight(std::uint32_t pass);
    void sampleDirectLight(std::uint32_t pass);
    void gatherIndirectLight(std::uint32_t pass);
    void drawPhotons();

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    const Film& film_;
    std::filesystem::path save_;
    std::filesystem::path load_;
    bool prepared_ = false;

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
    gpu::Array<shared::uint> shadowRayCounts_; // spared, traced
};

} // namespace hyalite::render
