// Isotropic point light. See light_sample.h.
#pragma once

#include "reference/lights/light_sample.h"
#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite::reference {

[[nodiscard]] Offer offerTo(const glm::dvec3& receiver, const PointLight& light, glm::dvec2 uv);
[[nodiscard]] double pdfToward(const PointLight& light, const glm::dvec3& direction, double distance,
                               const glm::dvec3& lightNormal);
[[nodiscard]] LightRay emitFrom(const PointLight& light, glm::dvec2 uOrigin, glm::dvec2 uDirection);
[[nodiscard]] double emissionDensity(const PointLight& light, const glm::dvec3& normal, const glm::dvec3& direction);
[[nodiscard]] double emissionCosine(const PointLight& light);
[[nodiscard]] std::optional<StartDisc> startDisc(const PointLight& light);
[[nodiscard]] glm::dvec3 fluxOf(const PointLight& light);

} // namespace hyalite::reference
