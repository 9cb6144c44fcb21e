// The lights of a scene: how likely each is picked, where light starts, and what arrives at a surface.
#pragma once

#include "reference/lib/sampling.h"
#include "reference/lights/area.h"
#include "reference/lights/directional.h"
#include "reference/lights/environment.h"
#include "reference/lights/light_sample.h"
#include "reference/lights/point.h"
#include "reference/lights/spot.h"
#include "reference/shapes/geometry.h"
#include "scene/model/bounds.h"
#include "scene/model/scene.h"

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace hyalite::reference {

struct World;
struct PhotonPass;

// The list of lights: each type has a file of its own, see light_sample.h.
struct Light {
    std::variant<PointLight, SpotLight, ParallelLight, SurroundingLight, AreaLight> shape;
    glm::dvec3 power; // flux [W]: 4 pi I of a point, pi A L of a surface; the others: see makeLights
    double share = 1; // weight of the power in the pmf
    double pmf = 0;   // probability that a photon or a shadow ray picks this light
    double cdf = 0;   // sum of the pmf up to and including this light; 1 for the last
    std::optional<std::uint32_t> object = std::nullopt; // of the scene, that emits; none: no object does
};

// The environment, points, spots and directional lights in the scene's order, then emitting objects in theirs; pmf in
// proportion to the mean of the flux's channels times the share (all 0 where nothing emits). The flux of parallel light
// is that through its disc, that of the environment what passes a disc across each direction as wide as lightSphere.
// Throws Error(BadInput) at an emitting object of another shape than quad, disk, sphere and mesh.
[[nodiscard]] std::vector<Light> makeLights(const Scene& scene);

// The first light with x < cdf; x in [0, 1). Some light must emit.
[[nodiscard]] std::uint32_t chooseLight(const std::vector<Light>& lights, double x);

// Where a camera path ends at a diffuse surface: there the lights are sampled, the photons are gathered and the BSDF is
// evaluated (reference/lights/receiver.h).
struct VisiblePoint {
    glm::dvec3 position;        // world [m]
    glm::dvec3 shadowOrigin;    // the same, moved off the surface to the side the path came from [m]
    glm::dvec3 normal;          // unit, for shading, on that side
    glm::dvec3 geometricNormal; // unit, on that side
    glm::dvec3 wo;              // unit, to where the path came from
    glm::dvec3 beta;            // path throughput, probability of the diffuse part divided out
    // With its textures multiplied in; none: the irradiance is asked for.
    std::optional<MaterialModel> material = std::nullopt;
    std::uint32_t depth = 0; // segments from the camera to here
    std::uint32_t samplerSeed = 0;
    const Quad* quad = nullptr; // of the world: the parallelogram that this is on; nullptr: another shape
};

// Which light is sampled, with which numbers: the light named, with a sequence of its own (whitted sums over all of
// them), or one picked by the pmf (ppm).
struct LightChoice {
    std::uint32_t depth = 0; // of the vertex that is lit
    std::uint32_t samplerSeed = 0;
    std::uint32_t pass = 0;
    std::optional<std::uint32_t> light = std::nullopt;
    double shift = 0; // of the numbers: see sampleUnitSquare
};

// What the chosen light sends to a receiver from the place that is chosen on it.
struct LightArrival {
    glm::dvec3 direction;  // unit, to that place
    glm::dvec3 shadowEnd;  // the place, moved off the light [m]
    glm::dvec3 irradiance; // of a surface that faces it, density of the choice divided out [W/m^2]
    double pdfW = 0;       // that density, the light's pmf in it [1/sr]; 0: no ray can hit the light
};
[[nodiscard]] LightArrival sampleArrival(const World& world, const glm::dvec3& receiver, const LightChoice& choice);

// One shadow ray: its two ends, moved off their surfaces, and the radiance it brings if nothing stands between.
struct LightSample {
    glm::dvec3 from;         // world [m]
    glm::dvec3 to;           // world [m]
    glm::dvec3 contribution; // [W/(m^2 sr)]
    double cosine = 0;       // of the angle to the surface's normal
    double pdfW = 0;         // density of the choice [1/sr]; 0: no ray can hit the light
};

// Samples one light, the one named or one picked, at a visible point in a pass; `shift`: see LightChoice. None: the
// light cannot reach that side.
[[nodiscard]] std::optional<LightSample> sampleLight(const World& world, const VisiblePoint& x, std::uint32_t pass,
                                                     std::optional<std::uint32_t> light, double shift = 0);

// Radiance [W/(m^2 sr)] from the unit direction, of rays that hit nothing.
[[nodiscard]] glm::dvec3 environmentRadiance(const World& world, const glm::dvec3& direction);

// Density [1/sr] with which sampleLight chooses the unit `direction` from a receiver that sees the light there, at this
// distance and with this normal (neither matters where it comes from beyond the scene); 0 where it chooses none, at
// lights that no ray can hit. The light's pmf is not in it.
[[nodiscard]] double lightPdf(const Light& light, const glm::dvec3& receiver, const glm::dvec3& direction,
                              double distance, const glm::dvec3& lightNormal);

// A ray of the light's photons, with a density in proportion to the flux.
[[nodiscard]] LightRay emitFrom(const Light& light, glm::dvec2 uOrigin, glm::dvec2 uDirection);

// Flux [W] of the light if all that it emits were like its rays in `direction`: on average over emitFrom, its power.
[[nodiscard]] glm::dvec3 rayPower(const Light& light, const glm::dvec3& direction);

// Density [1/sr] with which emitFrom would send `direction` from a point with this normal; 0 where it never would, and
// for parallel light.
[[nodiscard]] double emissionDensity(const Light& light, const glm::dvec3& normal, const glm::dvec3& direction);

// Density [1/m^2], across `direction`, with which emitFrom starts its rays of this direction on the line through
// `point`; 0 for lights that choose the origin first. Of parallel light the direction must be its own.
[[nodiscard]] double originDensity(const Light& light, const glm::dvec3& point, const glm::dvec3& direction);

// Cosine of the half-angle of the cone that holds all directions of the light from one of its points.
[[nodiscard]] double emissionCosine(const Light& light);

// Does a ray that nothing stops see the front of an emitting quad, disk or sphere? Never that of a mesh.
[[nodiscard]] bool looksAt(const Light& light, const glm::dvec3& origin, const glm::dvec3& direction);

struct Emission {
    Ray ray;
    glm::dvec3 power; // flux [W], light pmf and photon count divided out
    std::uint32_t light = 0;
};

// Emission of photon `photon` of a pass, from a light picked by the pmf. Some light must emit. `shift`: see
// sampleUnitSquare.
[[nodiscard]] Emission emitPhoton(const World& world, std::uint32_t photon, const PhotonPass& pass, double shift = 0);

} // namespace hyalite::reference
