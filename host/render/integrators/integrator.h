// What a way of computing light transport offers: independent passes, each of which adds one estimate per pixel.
#pragma once

#include "render/film/counts.h"
#include "render/photons/light_balance.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hyalite::render {

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
