// Interface of every light: its contribution to a receiver, and one ray from it into the scene. Each type of light has
// its own file with functions of these names:
//
//     Offer offerTo(receiver, light, uv)
//     double pdfToward(light, direction, distance, lightNormal)       see lightPdf
//     LightRay emitFrom(light, uOrigin, uDirection)                   its power is set by the list, lights.cpp
//     double emissionDensity(light, normal, direction)
//     double emissionCosine(light)                                    of the cone of all emitted directions
//     std::optional<StartDisc> startDisc(light)
//     glm::dvec3 fluxOf(light)                                        [W]
#pragma once

#include "reference/lib/sampling.h"

#include <glm/glm.hpp>
#include <numbers>

namespace hyalite::reference {

// Length of shadow rays to lights outside the scene [m].
inline constexpr double kBeyond = 1e30;

// A sampled place on a light as seen from a receiver, and the irradiance at a surface facing it, with the sampling
// density divided out.
struct Offer {
    glm::dvec3 toLight;       // from the receiver to that place [m]; kBeyond long for lights outside the scene
    glm::dvec3 shadowEnd;     // that place, moved off the light [m]
    glm::dvec3 irradiance{0}; // [W/m^2]
    double pdfW = 0;          // sampling density [1/sr]; 0: nothing to sample, and no ray can hit the light
};

// Offer of a point without a surface.
[[nodiscard]] inline Offer offerFrom(const glm::dvec3& place, const glm::dvec3& receiver, const glm::dvec3& intensity) {
    const glm::dvec3 way = place - receiver;
    return {.toLight = way, .shadowEnd = place, .irradiance = intensity / glm::dot(way, way)};
}

// How a photon leaves a light. The density of the ray is that of the origin times that of the direction given the
// origin; for parallel light and light from outside the scene, that of the direction times that of the origin given the
// direction.
struct LightRay {
    glm::dvec3 origin;       // world, on the light [m]
    glm::dvec3 direction;    // unit
    glm::dvec3 normal{0};    // unit, of the light at the origin; zero for a light without a surface
    double offset = 0;       // distance along the normal from the light to the start of the ray [m]
    glm::dvec3 power{0};     // flux [W] of the light if all its photons were like this one
    double pdfDirection = 0; // [1/sr], given the origin; 0: the origin was chosen for the direction
    double pdfOrigin = 0;    // [1/m^2] across the direction and given it; 0: the direction was chosen for the origin
};

// Where the light's ray starts [m].
[[nodiscard]] inline glm::dvec3 startOf(const LightRay& ray) {
    return ray.origin + ray.offset * ray.normal;
}

// Where photons of parallel light and of the environment start: a disc perpendicular to the direction of the photon.
struct StartDisc {
    glm::dvec3 center; // [m]
    double radius;     // [m]

    [[nodiscard]] double area() const { return std::numbers::pi * radius * radius; }
    [[nodiscard]] bool isPassed(const glm::dvec3& point, const glm::dvec3& direction) const {
        return glm::length(glm::cross(point - center, direction)) <= radius;
    }
    [[nodiscard]] glm::dvec3 point(const glm::dvec3& direction, glm::dvec2 uv) const {
        const glm::dvec2 at = radius * concentricDisc(uv);
        const Basis basis = orthonormalBasis(direction);
        return center + at.x * basis.tangent + at.y * basis.bitangent;
    }
};

} // namespace hyalite::reference
