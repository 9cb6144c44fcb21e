// Spot light: a point light within a cone about an axis. Its profile s(c) over the cosine c with the axis is 1 above
// the inner cosine, 0 below the outer one, and t^2 (3 - 2 t) between, with t = (c - outer) / (inner - outer). See
// light_sample.h.
#pragma once

#include "reference/lights/light_sample.h"
#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite::reference {

[[nodiscard]] Offer offerTo(const glm::dvec3& receiver, const SpotLight& light, glm::dvec2 uv);
[[nodiscard]] double pdfToward(const SpotLight& light, const glm::dvec3& direction, double distance,
                               const glm::dvec3& lightNormal);
[[nodiscard]] LightRay emitFrom(const SpotLight& light, glm::dvec2 uOrigin, glm::dvec2 uDirection);
[[nodiscard]] double emissionDensity(const SpotLight& light, const glm::dvec3& normal, const glm::dvec3& direction);
[[nodiscard]] double emissionCosine(const SpotLight& light);
[[nodiscard]] std::optional<StartDisc> startDisc(const SpotLight& light);
[[nodiscard]] glm::dvec3 fluxOf(const SpotLight& light);

} // namespace hyalite::reference
