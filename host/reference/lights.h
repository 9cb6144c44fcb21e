// The lights of a scene: how likely each is picked, where light starts, and what arrives at a surface.
#pragma once

#include "reference/geometry.h"
#include "reference/sampling.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace hyalite::reference {

struct World;
struct PhotonPass;

struct AreaLight {
    std::variant<Quad, Disk, Sphere> shape; // emits on its front
    double area = 0;                        // [m^2]
    glm::dvec3 radiance;                    // [W/(m^2 sr)]
};

struct Light {
    std::variant<PointLight, AreaLight> shape;
    glm::dvec3 power; // flux [W]: 4 pi I of a point, pi A L of an area
    double pmf = 0;   // probability that a photon or a shadow ray picks this light
    double cdf = 0;   // sum of the pmf up to and including this light; 1 for the last
};

// Points in the scene's order, then emitting objects in theirs; pmf in proportion to the mean of the flux's channels
// (all 0 where nothing emits). Throws Error(BadInput) at an emitting object of another shape than quad, disk
// and sphere.
[[nodiscard]] std::vector<Light> makeLights(const Scene& scene);

// The first light with x < cdf; x in [0, 1). Some light must emit.
[[nodiscard]] std::uint32_t chooseLight(const std::vector<Light>& lights, double x);

// Where a camera path first meets a diffuse surface: there the lights are sampled and the photons are gathered.
struct VisiblePoint {
    glm::dvec3 position;        // world [m]
    glm::dvec3 shadowOrigin;    // the same, moved off the surface to the side the path came from [m]
    glm::dvec3 normal;          // unit, for shading, on that side
    glm::dvec3 geometricNormal; // unit, on that side
    glm::dvec3 f;               // path throughput times the BRDF albedo / pi [1/sr]
    std::uint32_t depth = 0;    // segments from the camera to here
    std::uint32_t samplerSeed = 0;
};

// One shadow ray: its two ends, moved off their surfaces, and the radiance it brings if nothing stands between.
struct LightSample {
    glm::dvec3 from;         // world [m]
    glm::dvec3 to;           // world [m]
    glm::dvec3 contribution; // [W/(m^2 sr)]
};

// Samples one light at a visible point in a pass: the light named, with a sequence of its own (whitted sums over all of
// them), or one picked in proportion to power (ppm). None: the light cannot reach that side.
[[nodiscard]] std::optional<LightSample> sampleLight(const World& world, const VisiblePoint& x, std::uint32_t pass,
                                                     std::optional<std::uint32_t> light);

struct Emission {
    Ray ray;
    glm::dvec3 power; // flux [W], light pmf and photon count divided out
    std::uint32_t light = 0;
};

// Emission of photon `photon` of a pass, from a light picked in proportion to power. Some light must emit.
[[nodiscard]] Emission emitPhoton(const World& world, std::uint32_t photon, const PhotonPass& pass);

} // namespace hyalite::reference
