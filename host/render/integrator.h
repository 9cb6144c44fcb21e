// What a way of computing light transport offers: independent passes, each of which adds one estimate per pixel.
#pragma once

#include <cstdint>

namespace hyalite::render {

// Counts over all passes so far.
struct Counts {
    std::uint64_t cameraRays = 0;
    std::uint64_t shadowRays = 0;
    std::uint64_t photonRays = 0;
    std::uint64_t photonsEmitted = 0;
    std::uint64_t photonsStored = 0;
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

protected:
    Counts counts_;
};

} // namespace hyalite::render
