// A path that looks where light may go. It follows the geometry of reflection and refraction, not their strength: every
// direction that a surface may send light into is taken with some probability.
#pragma once

#include "reference/world.h"
#include "scene/checks/dice.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hyalite::checks {

struct ProbeVertex {
    glm::dvec3 position; // moved off the surface to the side that the path came from [m]
    glm::dvec3 normal;   // unit, on that side
    std::uint32_t object = 0;
    const Material* material = nullptr;
    std::uint32_t flags = 0;      // kBsdf... of the material
    bool isAfterSpecular = false; // all vertices before it are mirrors and smooth glass, and there is one
    bool isLit = false;           // of the front of an object that emits
};

struct ProbePath {
    std::vector<ProbeVertex> vertices;
    bool escapes = false; // its last ray hits nothing
};

// Whether the material bends or reflects light like a mirror and does nothing else; neither thin glass nor index 1.
[[nodiscard]] bool isSpecular(const Material& material);

// Follows a path over at most `most` surfaces.
[[nodiscard]] ProbePath follow(const reference::World& world, reference::Ray ray, int most, Dice& dice);

} // namespace hyalite::checks
