// What happens to a camera path at a hit: light seen, a diffuse surface found, or specular directions to follow.
#pragma once

#include "reference/lights/lights.h"
#include "reference/lights/rough_light.h"
#include "reference/world.h"

#include <array>
#include <cstdint>
#include <optional>

namespace hyalite::reference {

// The state of a camera path that has not yet met a diffuse surface.
struct CameraPath {
    glm::dvec3 beta{1};               // throughput: what one unit of radiance along the present ray adds to the pixel
    std::uint32_t samplerSeed = 0;    // see shared::pathSampler
    const Material* medium = nullptr; // of the world: the dielectric that it runs in; nullptr: none
    double pdfW = 0;                  // density of the present direction [1/sr]; 0: by the camera or a smooth surface
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

// Of a path whose ray hits nothing: it sees the environment.
[[nodiscard]] Shading shadeMiss(const World& world, const Ray& ray, const CameraPath& path);

// `depth` counts the segments from the camera to the hit. At smooth glass whitted follows both ways, weighted, unless
// their throughput is below render.minWeight; the others one, picked with the Fresnel reflectance, or with
// kShareToLight at least for the one way that leads to a lamp. Likewise, where a surface has a diffuse part
// and a lobe: one or both.
[[nodiscard]] Shading shadeSurface(const World& world, const Ray& ray, const Hit& hit, const CameraPath& path,
                                   std::uint32_t depth, std::uint32_t pass);

} // namespace hyalite::reference
