// What every light gives: what it offers a receiver, and one ray from it into the scene. Each type of light is a file
// with functions of these names:
//
//     Offer offerTo(receiver, light, uv)
//     double pdfToward(light, direction, distance, lightNormal)       see lightPdf
//     LightRay emitFrom(light, uOrigin, uDirection)                   its power is set by the list, lights.cpp
//     double emissionDensity(light, normal, direction)
//     double emissionCosine(light)                                    of the cone that holds all directions of its
//     light std::optional<StartDisc> startDisc(light) glm::dvec3 fluxOf(light) [W]
#pragma once

#include "reference/lib/sampling.h"

#include <glm/glm.hpp>
#include <numbers>

namespace hyalite::reference {

// Ends of shadow rays to lights beyond the scene are so far away [m].
inline constexpr double kBeyond = 1e30;

// The way from a receiver to a light, and the irradiance of a surface that faces that way, the density of the choice
// divided out.
struct Offer {
    glm::dvec3 way;           // to a place on the light [m]; kBeyond long where there is none
    glm::dvec3 shadowEnd;     // the place, moved off the light [m]
    glm::dvec3 irradiance{0}; // [W/m^2]
    double pdfW = 0;          // that density [1/sr]; 0: no choice, and no ray can hit the light
};

// From a place without a surface.
[[nodiscard]] inline Offer offerFrom(const glm::dvec3& place, const glm::dvec3& receiver, const glm::dvec3& intensity) {
    const glm::dvec3 way = place - receiver;
    return {.way = way, .shadowEnd = place, .irradiance = intensity / glm::dot(way, way)};
}

// How a photon leaves a light. The density of the whole ray is that of the origin times that of the direction given the
// origin; where light is parallel or comes from beyond the scene, of the direction times that of the origin.
struct LightRay {
    glm::dvec3 origin;       // world, on the light [m]
    glm::dvec3 direction;    // unit
    glm::dvec3 normal{0};    // unit, of the light at the origin; zero where it has no surface
    double offset = 0;       // along the normal: the ray starts so far off the light [m]
    glm::dvec3 power{0};     // flux [W] of the light if all its photons were like this one
    double pdfDirection = 0; // [1/sr], given the origin; 0: the origin was chosen for the direction
    double pdfOrigin = 0;    // [1/m^2] across the direction and given it; 0: the direction was chosen for the origin
};

// Where a ray of the light's starts [m].
[[nodiscard]] inline glm::dvec3 startOf(const LightRay& ray) {
    return ray.origin + ray.offset * ray.normal;
}

// Where photons of parallel light and of the environment start: a disc across the light, whichever way that goes.
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
