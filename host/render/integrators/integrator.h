// What a way of computing light transport offers: independent passes, each of which adds one estimate per pixel.
#pragma once

#include "render/photons/light_balance.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hyalite::render {

// Counts over all passes so far.
struct Counts {
    std::uint64_t cameraRays = 0;
    std::uint64_t shadowRays = 0;
    std::uint64_t photonRays = 0;
    std::uint64_t photonsEmitted = 0;
    std::uint64_t photonsStored = 0;
    std::uint64_t shadowRaysSaved = 0;       // photonmap: answered by shadow photons
    std::uint64_t causticPhotonsEmitted = 0; // ppm, photonmap: for the caustics alone
    std::uint64_t causticPhotonsStored = 0;

    Counts& operator+=(const Counts& more);
};

inline Counts& Counts::operator+=(const Counts& more) {
    cameraRays += more.cameraRays;
    shadowRays += more.shadowRays;
    photonRays += more.photonRays;
    photonsEmitted += more.photonsEmitted;
    photonsStored += more.photonsStored;
    shadowRaysSaved += more.shadowRaysSaved;
    causticPhotonsEmitted += more.causticPhotonsEmitted;
    causticPhotonsStored += more.causticPhotonsStored;
    return *this;
}

// What a user should know of a picture besides the picture.
struct RenderNotes {
    double searchRadius = 0;           // ppm: of the first pass [m]
    double causticSearchRadius = 0;    // ppm: the same among the caustic photons [m]; 0: these have no map of their own
    std::vector<LightBalance> lights;  // photonmap: what became of the flux of each light
    std::vector<std::string> warnings; // sentences
};

class PassIntegrator {
public:
    PassIntegrator() = default;
    PassIntegrator(const PassIntegrator&) = delete;
    PassIntegrator& operator=(const PassIntegrator&) = delete;
    virtual ~PassIntegrator() = default;

    // Adds pass number `pass` to the film. A pass depends on its number alone, not on the passes before it.
    virtual void renderPass(std::uint32_t pass) = 0;

    [[nodiscard]] const Counts& counts() const { return counts_; }
    [[nodiscard]] const RenderNotes& notes() const { return notes_; }

protected:
    Counts counts_;
    RenderNotes notes_;
};

} // namespace hyalite::render
