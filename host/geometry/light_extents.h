// Where each light is and where to it shines, in bounds: enough to estimate which lights matter at a place.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <numbers>
#include <vector>

namespace hyalite {

struct LightExtent {
    Bounds box{};             // of the light [m]; unused if isFar
    glm::dvec3 center{0};     // of a sphere around the light; beam: of the disc where it starts [m]
    double radius = 0;        // of that sphere or disc [m]; light from beyond the scene: 0
    glm::dvec3 axis{0, 0, 1}; // unit, of the cone in which the light shines undiminished (a surface: the cone of
                              // its normals); beam: the light's direction
    double spread = std::numbers::pi;   // half-angle of that cone [rad]
    double fade = std::numbers::pi / 2; // angle outside the cone at which nothing is left of the light [rad]
    double intensity = 0; // largest, mean of the channels times photon share [W/sr]; if isFar, irradiance [W/m^2]
    bool isFar = false;   // parallel light or an environment: its strength does not fall off with distance
};

// In the order of the lights: the environment, points, spots and directional lights in the scene's order, then emitting
// objects in theirs.
[[nodiscard]] std::vector<LightExtent> lightExtents(const Scene& scene);

} // namespace hyalite
