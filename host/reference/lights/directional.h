// Light of one direction: over all of the scene from beyond it, or from a disc on and no wider than it. See
// light_sample.h.
#pragma once

#include "reference/lights/light_sample.h"
#include "scene/model/bounds.h"
#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite::reference {

struct ParallelLight {
    glm::dvec3 direction;      // unit, where the light goes
    glm::dvec3 irradiance;     // of a surface that faces it [W/m^2]
    bool isEverywhere = false; // lights what the disc does not cover too, and comes from beyond the scene
    glm::dvec3 center{0};      // of the disc where its photons start [m]
    double radius = 0;         // of that disc [m]
};

[[nodiscard]] ParallelLight makeParallel(const DirectionalLight& light, const LightSphere& sphere);

[[nodiscard]] Offer offerTo(const glm::dvec3& receiver, const ParallelLight& light, glm::dvec2 uv);
[[nodiscard]] double pdfToward(const ParallelLight& light, const glm::dvec3& direction, double distance,
                               const glm::dvec3& lightNormal);
[[nodiscard]] LightRay emitFrom(const ParallelLight& light, glm::dvec2 uOrigin, glm::dvec2 uDirection);
[[nodiscard]] double emissionDensity(const ParallelLight& light, const glm::dvec3& normal, const glm::dvec3& direction);
[[nodiscard]] double emissionCosine(const ParallelLight& light);
[[nodiscard]] std::optional<StartDisc> startDisc(const ParallelLight& light);
[[nodiscard]] glm::dvec3 fluxOf(const ParallelLight& light);

} // namespace hyalite::reference
