// A camera path at a hit: emission seen, a diffuse surface reached, or specular directions to follow.
#pragma once

#include "reference/lights/lights.h"
#include "reference/lights/rough_light.h"
#include "reference/media/medium.h"
#include "reference/world.h"

#include <array>
#include <cstdint>
#include <optional>

namespace hyalite::reference {

// The state of a camera path that has not yet met a diffuse surface.
struct CameraPath {
    glm::dvec3 beta{1};            // throughput: what unit radiance along the current ray adds to the pixel
    std::uint32_t samplerSeed = 0; // see shared::pathSampler
    Media media = {};              // around the ray
    double pdfW = 0;               // density of the current direction [1/sr]; 0: from the camera or a smooth surface
};

// The path that starts at the camera.
[[nodiscard]] CameraPath beginCameraPath(const World& world, std::uint32_t pixel, std::uint32_t pass);

struct NextRay {
    Ray ray;
    CameraPath path;
};

struct Shading {
    glm::dvec3 emitted{0};                      // radiance added to the pixel, throughput included
    std::optional<VisiblePoint> visible;        // on a diffuse surface
    std::optional<RoughPoint> rough;            // on a rough one
    std::array<std::optional<NextRay>, 2> next; // reflected or by a rough lobe, refracted
};

// For a path whose ray hits nothing: it sees the environment.
[[nodiscard]] Shading shadeMiss(const World& world, const Ray& ray, const CameraPath& path);

// `depth` counts the segments from the camera to the hit. At smooth glass whitted follows reflection and refraction,
// weighted, unless their throughput is below render.minWeight. The other integrators follow one of them, picked by the
// Fresnel reflectance; if only one leads to a light, its probability is at least kShareToLight. Where a surface has a
// diffuse part and a lobe, whitted follows both and the others pick one.
[[nodiscard]] Shading shadeSurface(const World& world, const Ray& ray, const Hit& hit, const CameraPath& path,
                                   std::uint32_t depth, std::uint32_t pass);

// True if that pass's path of the pixel reaches a surface that reflects light diffusely or by a rough lobe, and may be
// one segment longer to look for light there: if the pixel is black, its light may not have been found yet.
[[nodiscard]] bool seeksLight(const World& world, std::uint32_t pixel, std::uint32_t pass);

} // namespace hyalite::reference
