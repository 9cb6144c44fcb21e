// Progressive photon mapping with independent passes [Knaus11].
#pragma once

#include "render/device_scene.h"
#include "render/film.h"
#include "render/integrator.h"
#include "render/path_queue.h"
#include "render/photon_grid.h"

namespace hyalite::render {

// Search radius of a pass: the first pass searches `initial` [m], later ones less, such that a share alpha of the
// photons that a constant radius would add is kept, and both bias and variance vanish [Knaus11].
[[nodiscard]] double searchRadius(double initial, double alpha, std::uint32_t pass);

class Ppm final : public PassIntegrator {
public:
    // References are kept.
    Ppm(Device& device, const Scene& scene, const DeviceScene& deviceScene, const Film& film);

    void renderPass(std::uint32_t pass) override;

private:
    void traceCameraPaths(std::uint32_t pass);
    void sampleDirectLight(std::uint32_t pass);
    std::uint32_t tracePhotons(std::uint32_t pass);
    void gatherPhotons(std::uint32_t pass, std::uint32_t slots);
    void reservePhotons(std::uint32_t slots);

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    const Film& film_;
    double initialRadius_;

    gpu::Kernel generateCameraRays_;
    gpu::Kernel traceClosest_;
    gpu::Kernel shadeSurface_;
    gpu::Kernel compactCameraPaths_;
    gpu::Kernel sampleLights_;
    gpu::Kernel traceShadow_;
    gpu::Kernel emitPhotons_;
    gpu::Kernel scatterPhoton_;
    gpu::Kernel compactPhotonPaths_;
    gpu::Kernel gatherRadiance_;
    gpu::Kernel accumulateFilm_;
    PrefixSum prefixSum_;
    PhotonGrid grid_;

    CameraQueue camera_;
    PhotonQueue photonQueue_;
    gpu::Array<shared::Photon> photons_; // as they land, bounce after bounce, with gaps
    gpu::Array<shared::VisiblePoint> visiblePoints_;
    gpu::Array<shared::Ray> shadowRays_;
    gpu::Array<glm::vec3> contributions_;
    gpu::Array<glm::vec3> emitted_;
    gpu::Array<glm::vec3> direct_;
    gpu::Array<glm::vec3> gathered_;
};

} // namespace hyalite::render
