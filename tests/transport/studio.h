// A small scene in parts, which the symmetries change one at a time.
#pragma once

#include "transport/scene_text.h"

#include <vector>

namespace hyalite::testing {

// A map of space that keeps shapes similar: scaled, turned about an axis, then moved.
struct Placement {
    double scale = 1;
    glm::dvec3 axis{0, 1, 0};
    double degrees = 0;
    glm::dvec3 move{0};

    [[nodiscard]] glm::dvec3 point(const glm::dvec3& p) const;
    [[nodiscard]] glm::dvec3 direction(const glm::dvec3& d) const;
    // Value of an object's key `transform`.
    [[nodiscard]] std::string transform() const;
};

// Texts of the parts of a scene file. Lengths and positions of lights and camera are numbers, so that a placement may
// move them; objects are moved by their transforms.
struct PointOfLight {
    glm::dvec3 position{0};
    double intensity = 1; // [W/sr]
};
struct Studio {
    glm::dvec3 eye{0, 1.5, 4.5};
    glm::dvec3 target{0, 0.7, 0};
    glm::dvec3 up{0, 1, 0};
    double fov = 40;
    std::string materials;
    std::vector<PointOfLight> points;
    std::vector<std::string> lights;  // items that no placement moves
    std::vector<std::string> objects; // the keys of each object, without braces
    double searchRadius = 0.15;       // of photons [m]
    std::string settings;             // further keys of `render`, each followed by a comma

    [[nodiscard]] std::string at(const Placement& placement = {}) const;
};

// A floor and a wall with a glass ball, a mirror box, a ring and a hollowed metal block, under a square light and a
// point light.
[[nodiscard]] Studio furnishedStudio();

// The floor and the wall alone, under the same lights, and one object of the material "m" (a grey unless given).
[[nodiscard]] Studio studioWith(const std::vector<std::string>& objects,
                                const std::string& material = "{type: diffuse, albedo: 0.6}");

} // namespace hyalite::testing
