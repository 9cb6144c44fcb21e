// The lights of a scene: selection probabilities, emitted rays, and the light arriving at a surface.
#pragma once

#include "reference/lib/sampling.h"
#include "reference/lights/area.h"
#include "reference/lights/directional.h"
#include "reference/lights/environment.h"
#include "reference/lights/light_sample.h"
#include "reference/lights/point.h"
#include "reference/lights/spot.h"
#include "reference/media/medium.h"
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

// A light of any type; each type has its own file, see light_sample.h.
struct Light {
    std::variant<PointLight, SpotLight, ParallelLight, SurroundingLight, AreaLight> shape;
    glm::dvec3 power; // flux [W]: 4 pi I of a point, pi A L of a surface; for others see makeLights
    double share = 1; // weight in the pmf
    double pmf = 0;   // probability that a photon picks this light; see also light_choice.h
    double cdf = 0;   // sum of the pmf up to and including this light; 1 for the last
    std::optional<std::uint32_t> object = std::nullopt; // the emitting object of the scene; none: not an object
    Media media = {};                                   // around it: there its photons start
};

// The environment, points, spots and directional lights in the scene's order, then emitting objects in theirs. A part
// kEvenPhotons of the pmf is proportional to the share, the rest to the share times the mean of the flux's channels
// (all 0 if nothing emits). The flux of parallel light is that through its disc; the flux of the environment is
// integrated over all directions, each through a disc of the radius of lightSphere. Throws Error(BadInput) if an
// emitting object is not a quad, disk, sphere or mesh.
[[nodiscard]] std::vector<Light> makeLights(const Scene& scene);

// The first light with x < cdf; x in [0, 1). At least one light must emit.
[[nodiscard]] std::uint32_t chooseLight(const std::vector<Light>& lights, double x);

// Diffuse surface point at the end of a camera path: the lights are sampled, the photons gathered and the BSDF
// evaluated (reference/lights/receiver.h) here.
struct VisiblePoint {
    glm::dvec3 position;        // world [m]
    glm::dvec3 shadowOrigin;    // the position, moved off the surface to the side the path came from [m]
    glm::dvec3 normal;          // unit, for shading, on that side
    glm::dvec3 geometricNormal; // unit, on that side
    glm::dvec3 wo;              // unit, towards the origin of the path's last segment
    glm::dvec3 beta;            // path throughput, probability of the diffuse part divided out
    // Textures multiplied in; none: compute irradiance.
    std::optional<MaterialModel> material = std::nullopt;
    std::uint32_t depth = 0; // segments from the camera to here
    std::uint32_t samplerSeed = 0;
    const Quad* quad = nullptr; // of the world: the parallelogram under this point; nullptr: another shape
    Media media = {};           // on this side
    const Disk* disk = nullptr; // likewise, the disk
};

// Which light to sample, with which random numbers: the given light, with its own sequence (whitted sums over all
// lights), or one picked for the receiver (ppm).
struct LightChoice {
    std::uint32_t depth = 0; // of the lit vertex
    std::uint32_t samplerSeed = 0;
    std::uint32_t pass = 0;
    std::optional<std::uint32_t> light = std::nullopt;
    double shift = 0; // of the random numbers: see sampleUnitSquare
};

// Light arriving at a receiver from the sampled place on the sampled light.
struct LightArrival {
    glm::dvec3 direction;  // unit, to that place
    glm::dvec3 shadowEnd;  // the place, moved off the light [m]
    glm::dvec3 irradiance; // at a surface facing it, sampling density divided out [W/m^2]
    double pdfW = 0;       // sampling density, light pmf included [1/sr]; 0: no ray can hit the light
};
[[nodiscard]] LightArrival sampleArrival(const World& world, const glm::dvec3& receiver, const LightChoice& choice);

// One shadow ray: its two ends, moved off their surfaces, and its contribution if unoccluded, absorption included. A
// ray that passes goes on through thin glass and through boundaries of matching index; what absorbs it is left to
// arriving().
struct LightSample {
    glm::dvec3 from;         // world [m]
    glm::dvec3 to;           // world [m]
    glm::dvec3 contribution; // [W/(m^2 sr)]
    double cosine = 0;       // of the angle to the surface's normal
    double pdfW = 0;         // sampling density [1/sr]; 0: no ray can hit the light
    Media media = {};        // around its start
    bool passes = false;
};

// Samples one light, given or picked for it, at a visible point in a pass; `shift`: see LightChoice. None: the
// light cannot reach that side of the surface.
[[nodiscard]] std::optional<LightSample> sampleLight(const World& world, const VisiblePoint& x, std::uint32_t pass,
                                                     std::optional<std::uint32_t> light, double shift = 0);

// The sample with the absorption of the media around its ray, unless it passes.
[[nodiscard]] LightSample inMedia(const World& world, LightSample sample);

// The light that arrives along the sample's ray; 0: it is occluded.
[[nodiscard]] glm::dvec3 arriving(const World& world, const LightSample& sample);

// Radiance [W/(m^2 sr)] from the unit direction, for rays that hit nothing.
[[nodiscard]] glm::dvec3 environmentRadiance(const World& world, const glm::dvec3& direction);

// Density [1/sr] with which sampleLight samples the unit `direction` from a receiver that sees the light at this
// distance and with this normal (both ignored for light from outside the scene); 0 for lights that no ray can hit. The
// light's pmf is not included.
[[nodiscard]] double lightPdf(const Light& light, const glm::dvec3& receiver, const glm::dvec3& direction,
                              double distance, const glm::dvec3& lightNormal);

// Samples a photon ray of the light, with a density proportional to its flux.
[[nodiscard]] LightRay emitFrom(const Light& light, glm::dvec2 uOrigin, glm::dvec2 uDirection);

// Flux [W] of the light if all its emission were like its rays in `direction`; averages to its power over emitFrom.
[[nodiscard]] glm::dvec3 rayPower(const Light& light, const glm::dvec3& direction);

// Density [1/sr] with which emitFrom samples `direction` from a point with this normal; 0 for directions it never
// samples, and for parallel light.
[[nodiscard]] double emissionDensity(const Light& light, const glm::dvec3& normal, const glm::dvec3& direction);

// Density [1/m^2], perpendicular to `direction`, with which emitFrom starts rays of this direction on the line through
// `point`; 0 for lights that choose the origin first. For parallel light, `direction` must be the light's.
[[nodiscard]] double originDensity(const Light& light, const glm::dvec3& point, const glm::dvec3& direction);

// Cosine of the half-angle of the cone containing all directions emitted from one point of the light.
[[nodiscard]] double emissionCosine(const Light& light);

// True if the ray, ignoring occlusion, hits the front of an emitting quad, disk or sphere. Always false for a mesh.
[[nodiscard]] bool looksAt(const Light& light, const glm::dvec3& origin, const glm::dvec3& direction);

struct Emission {
    Ray ray;
    glm::dvec3 power; // flux [W], light pmf and photon count divided out
    std::uint32_t light = 0;
};

// Emission of photon `photon` of a pass, from a light picked by the pmf. At least one light must emit. `shift`: see
// sampleUnitSquare.
[[nodiscard]] Emission emitPhoton(const World& world, std::uint32_t photon, const PhotonPass& pass, double shift = 0);

} // namespace hyalite::reference
