// Progressive photon mapping with independent passes [Knaus11].
#pragma once

#include "render/integrators/integrator.h"
#include "render/photons/photon_grid.h"
#include "render/photons/photon_paths.h"
#include "render/wavefront/camera_paths.h"
#include "render/wavefront/light_sampler.h"

namespace hyalite::render {

// Search radius of a pass: the first pass searches `initial` [m], later ones less, so that the share alpha of the
// photons that a constant radius would add is kept, and both bias and variance vanish [Knaus11].
[[nodiscard]] double searchRadius(double initial, double alpha, std::uint32_t pass);

class Ppm final : public PassIntegrator {
public:
    [[nodiscard]] static IntegratorKind kind();

    explicit Ppm(const IntegratorInput& input);

    // If the settings leave a search radius open, determines it from the density of a few photons.
    void prepare() override;
    void renderPass(std::uint32_t pass) override;

private:
    // The photons of a pass that light one layer of the film.
    struct Photons {
        std::uint32_t purpose; // shared::kGlobalPhotons, kCausticPhotons
        std::uint32_t count;   // emitted
        std::uint32_t kinds;   // kinds stored, see PhotonPass
        bool aimed;
        std::uint32_t layer;
        double radius; // search radius of pass 0 [m]; 0: prepare() determines it
    };
    [[nodiscard]] static std::vector<Photons> photonsOf(const Scene& scene, const DeviceScene& deviceScene);
    [[nodiscard]] PhotonPass photonPass(const Photons& photons, std::uint32_t pass) const;
    [[nodiscard]] std::vector<glm::dvec3> tracePilot(const PhotonPass& pilot); // where its photons landed [m]
    [[nodiscard]] double radiusByPilot(const Photons& photons);

    void sampleDirectLight(std::uint32_t pass);
    void gather(const Photons& photons, std::uint32_t pass);

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    Film& film_;

    CameraPaths cameraPaths_;
    LightSampler lightSampler_;
    PhotonPaths photonPaths_;
    PhotonGrid grid_;
    gpu::Kernel gatherRadiance_;
    std::vector<Photons> photons_;

    gpu::Array<shared::VisiblePoint> visiblePoints_;
    gpu::Array<glm::vec3> emitted_;
    gpu::Array<glm::vec3> direct_;
    gpu::Array<glm::vec3> gathered_;
};

} // namespace hyalite::render
