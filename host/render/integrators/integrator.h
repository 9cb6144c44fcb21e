// The interface of an integrator: independent passes, each of which adds one estimate per pixel.
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

// What a user should know about a picture beyond the picture itself.
struct RenderNotes {
    double searchRadius = 0;           // ppm: radius of the first pass [m]
    double causticSearchRadius = 0;    // ppm: the same for caustic photons [m]; 0: there is no caustic map
    std::vector<LightBalance> lights;  // photonmap: where the flux of each light went
    std::vector<std::string> warnings; // sentences
};

// Files of photon maps, for the integrators that keep photon maps (IntegratorKind::keepsPhotons).
struct PhotonFiles {
    std::filesystem::path save; // write the maps here; empty: do not write them
    std::filesystem::path load; // read them from here instead of tracing them; empty: trace them
};

// The inputs of an integrator. It keeps the references.
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

    // Determines parameters of the passes, such as search radii; nothing traced here is part of the picture. Called
    // once, before begin().
    virtual void prepare() {}

    // Builds data that all passes share, such as photon maps. Called once, before the first pass.
    virtual void begin() {}

    // Adds pass number `pass` to the film. A pass depends only on its number, not on earlier passes.
    virtual void renderPass(std::uint32_t pass) = 0;

    [[nodiscard]] const Counts& counts() const { return counts_; }
    [[nodiscard]] const RenderNotes& notes() const { return notes_; }

protected:
    Counts counts_;
    RenderNotes notes_;
};

// An integrator as the renderer knows it. Together with its row in scene/model/integrators.h this is all that the rest
// of the program needs.
struct IntegratorKind {
    std::string_view name;                                   // the name in that row
    std::vector<LayerKind> (*layers)(const RenderSettings&); // layers of its film
    std::unique_ptr<PassIntegrator> (*make)(const IntegratorInput&);
    reference::Integrator reference; // the double-precision reference
    bool referenceHasLayers = false; // the reference's pictures have layers too
    bool keepsPhotons = false;       // the photons of pass 0 serve all passes, and may be saved and loaded
    // Changes settings that no path depends on, so that rendering a pass only for its paths costs little more than the
    // paths; nullptr: there are no such settings.
    void (*simplifyForPaths)(RenderSettings&) = nullptr;
};

template <class T>
[[nodiscard]] std::unique_ptr<PassIntegrator> makeIntegrator(const IntegratorInput& input) {
    return std::make_unique<T>(input);
}

} // namespace hyalite::render
