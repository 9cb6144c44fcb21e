// Light from beyond the scene: an equirectangular image of radiance, constant over each pixel, and directions sampled
// from it. The middle of the image is seen along -z, its upper edge is +y.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <vector>

namespace hyalite::reference {

class EnvironmentLight {
public:
    explicit EnvironmentLight(const Environment& environment);

    // From the unit direction, seen from the scene [W/(m^2 sr)].
    [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction) const;

    // Over all directions [W/m^2].
    [[nodiscard]] const glm::dvec3& integral() const { return integral_; }

    // A direction towards the light: a pixel with a probability in proportion to the mean of its channels times its
    // solid angle, then any direction of it.
    [[nodiscard]] glm::dvec3 sample(glm::dvec2 uv) const;

    // Density [1/sr] of sample().
    [[nodiscard]] double pdfW(const glm::dvec3& direction) const;

private:
    Image image_;
    double scale_;
    double turns_;                               // about +y, counter-clockwise
    glm::dvec3 integral_{0};                     // [W/m^2]
    std::vector<double> rowCdf_;                 // 1 for the last
    std::vector<std::vector<double>> columnCdf_; // of each row; likewise
};

} // namespace hyalite::reference
