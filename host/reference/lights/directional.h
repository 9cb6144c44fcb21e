// Light of one direction: over the whole scene from outside it, or a beam that starts at a disc. See light_sample.h.
#pragma once

#include "reference/lights/light_sample.h"
#include "scene/model/bounds.h"
#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite::reference {

struct ParallelLight {
    glm::dvec3 direction;      // unit, along the propagation
    glm::dvec3 irradiance;     // at a surface facing the light [W/m^2]
    bool isEverywhere = false; // comes from outside the scene and lights everything, also what the disc does not cover
    glm::dvec3 center{0};      // of the disc from which its photons start [m]
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
