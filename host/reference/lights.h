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
    glm::dvec3 power;                                   // flux [W]: 4 pi I of a point, pi A L of an area
    double pmf = 0;                                     // probability that a photon or a shadow ray picks this light
    double cdf = 0;                                     // sum of the pmf up to and including this light; 1 for the last
    std::optional<std::uint32_t> object = std::nullopt; // of the scene, that emits; none: no object does
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
    glm::dvec3 f;               // path throughput times the BRDF [1/sr]
    std::uint32_t depth = 0;    // segments from the camera to here
    std::uint32_t samplerSeed = 0;
    bool coated = false; // f is to be multiplied by coatTransmission of the angle of incidence
};

// Which light is sampled, with which numbers: the light named, with a sequence of its own, or one picked in proportion
// to power.
struct LightChoice {
    std::uint32_t depth = 0; // of the vertex that is lit
    std::uint32_t samplerSeed = 0;
    std::uint32_t pass = 0;
    std::optional<std::uint32_t> light = std::nullopt;
};

// What the chosen light sends to a receiver from the point that is chosen on it.
struct LightArrival {
    glm::dvec3 position;   // of the point, world [m]
    glm::dvec3 shadowEnd;  // the same, moved off the light
    glm::dvec3 irradiance; // of a surface that faces it, density of the choice divided out [W/m^2]
    double pdfW = 0;       // that density [1/sr]; 0: light comes from this one direction only
};
[[nodiscard]] LightArrival sampleArrival(const World& world, const glm::dvec3& receiver, const LightChoice& choice);

// Density [1/sr], once the light is chosen, of the direction to a point of it `distance` away [m] with this normal,
// that sends light in the unit direction `fromLight`.
[[nodiscard]] double lightPdfW(const AreaLight& light, const glm::dvec3& normal, const glm::dvec3& fromLight,
                               double distance);

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
