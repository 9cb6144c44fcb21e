// Environment light: an equirectangular image of radiance, constant over each pixel, and directions sampled from it.
// The centre of the image is along -z, its upper edge is +y.
#pragma once

#include "reference/lights/light_sample.h"
#include "scene/model/bounds.h"
#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace hyalite::reference {

class EnvironmentLight {
public:
    explicit EnvironmentLight(const Environment& environment);

    // Radiance arriving from the unit direction, as seen from the scene [W/(m^2 sr)].
    [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction) const;

    // Integral of the radiance over all directions [W/m^2].
    [[nodiscard]] const glm::dvec3& integral() const { return integral_; }

    // A direction towards the light: a pixel with probability proportional to the mean of its channels times its solid
    // angle, then a uniform direction within it.
    [[nodiscard]] glm::dvec3 sample(glm::dvec2 uv) const;

    // Density [1/sr] of sample().
    [[nodiscard]] double pdfW(const glm::dvec3& direction) const;

private:
    Image image_;
    double scale_;
    double turns_;                               // about +y, counter-clockwise
    glm::dvec3 integral_{0};                     // [W/m^2]
    std::vector<double> rowCdf_;                 // 1 for the last
    std::vector<std::vector<double>> columnCdf_; // of each row; 1 for the last
};

// The environment, and the sphere at which its photons are aimed.
struct SurroundingLight {
    EnvironmentLight map;
    LightSphere sphere;
};

// See light_sample.h.
[[nodiscard]] Offer offerTo(const glm::dvec3& receiver, const SurroundingLight& light, glm::dvec2 uv);
[[nodiscard]] double pdfToward(const SurroundingLight& light, const glm::dvec3& direction, double distance,
                               const glm::dvec3& lightNormal);
[[nodiscard]] LightRay emitFrom(const SurroundingLight& light, glm::dvec2 uOrigin, glm::dvec2 uDirection);
[[nodiscard]] double emissionDensity(const SurroundingLight& light, const glm::dvec3& normal,
                                     const glm::dvec3& direction);
[[nodiscard]] double emissionCosine(const SurroundingLight& light);
[[nodiscard]] std::optional<StartDisc> startDisc(const SurroundingLight& light);
// Flux [W] of the light if all its emission were like its rays in `direction`.
[[nodiscard]] glm::dvec3 rayPower(const SurroundingLight& light, const glm::dvec3& direction);
[[nodiscard]] glm::dvec3 fluxOf(const SurroundingLight& light);

} // namespace hyalite::reference
