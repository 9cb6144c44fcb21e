// What a way of computing light transport offers: independent passes, each of which adds one estimate per pixel.
#pragma once

#include "reference/render.h"
#include "render/film/counts.h"
#include "render/film/film.h"
#include "render/photons/light_balance.h"
#include "render/upload/device_scene.h"
#include "render/wavefront/device.h"
#include "scene/model/scene.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite::render {

// What a user should know of a picture besides the picture.
struct RenderNotes {
    double searchRadius = 0;           // ppm: of the first pass [m]
    double causticSearchRadius = 0;    // ppm: the same among the caustic photons [m]; 0: these have no map of their own
    std::vector<LightBalance> lights;  // photonmap: what became of the flux of each light
    std::vector<std::string> warnings; // sentences
};

// Files of photon maps, for the integrators that keep them (IntegratorKind::keepsPhotons).
struct PhotonFiles {
    std::filesystem::path save; // write the maps here; empty: do not
    std::filesystem::path load; // read them from here instead of tracing them; empty: trace them
};

// What an integrator works with. References are kept.
struct IntegratorInput {
    Device& device;
    const Scene& scene;
    const DeviceScene& deviceScene;
    Film& film; // with the integrator's layers
    PhotonFiles photonFiles = {};
};

class PassIntegrator {
public:
    PassIntegrator() = default;
    PassIntegrator(const PassIntegrator&) = delete;
    PassIntegrator& operator=(const PassIntegrator&) = delete;
    virtual ~PassIntegrator() = default;

    // Finds what the passes go by, such as search radii; nothing that it traces is part of the picture. Once, before
    // begin().
    virtual void prepare() {}

    // Makes what all passes share, such as photon maps. Once, before the first pass.
    virtual void begin() {}

    // Adds pass number `pass` to the film. A pass depends on its number alone, not on the passes before it.
    virtual void renderPass(std::uint32_t pass) = 0;

    [[nodiscard]] const Counts& counts() const { return counts_; }
    [[nodiscard]] const RenderNotes& notes() const { return notes_; }

protected:
    Counts counts_;
    RenderNotes notes_;
};

// An integrator as the renderer knows it. With its row in scene/model/integrators.h this is all that the rest of the
// program needs of it.
struct IntegratorKind {
    std::string_view name;                                   // of that row
    std::vector<LayerKind> (*layers)(const RenderSettings&); // of its film
    std::unique_ptr<PassIntegrator> (*make)(const IntegratorInput&);
    reference::Integrator reference; // the same in double precision
    bool referenceHasLayers = false; // whose pictures keep their layers too
    bool keepsPhotons = false;       // those of pass 0 serve all passes, and may be saved and loaded
    // Changes settings that no path depends on, so that rendering a pass for the sake of its paths costs little more
    // than they do; nullptr: there are none.
    void (*simplifyForPaths)(RenderSettings&) = nullptr;
};

template <class T>
[[nodiscard]] std::unique_ptr<PassIntegrator> makeIntegrator(const IntegratorInput& input) {
    return std::make_unique<T>(input);
}

} // namespace hyalite::render
