// Photon mapping in two passes [Jensen96, Jensen01]: photons from the lights into maps, then rays from the eye that
// look up in the maps what they do not compute themselves.
#pragma once

#include "reference/integrators/shading.h"
#include "reference/photons/photon_map.h"
#include "reference/photons/radiance_estimate.h"
#include "reference/world.h"

#include <cstdint>
#include <optional>

namespace hyalite::reference {

// Radiance through a pixel, split by the path that the light took to the last diffuse surface [W/(m^2 sr)].
struct LightComponents {
    glm::dvec3 emitted{0};  // the light itself, also via mirrors and glass
    glm::dvec3 direct{0};   // straight from a light
    glm::dvec3 caustic{0};  // via mirrors and glass only
    glm::dvec3 indirect{0}; // via another diffuse surface

    LightComponents& operator+=(const LightComponents& other);
};

struct PhotonMaps {
    PhotonMap global;                    // direct, indirect and caustic photons
    std::optional<PhotonMap> caustic;    // caustic photons only; none: nothing specular in the scene, or switched off
    std::optional<PhotonMap> shadow;     // direct and shadow photons
    std::optional<PhotonMap> irradiance; // every fourth photon of the global map, its power the irradiance [W/m^2]
    double globalRadius = 0;             // largest of an estimate from the global map [m]
    double causticRadius = 0;            // likewise, from the caustic map
};

[[nodiscard]] PhotonMaps buildPhotonMaps(const World& world);

[[nodiscard]] LightComponents photonMapRadiance(const World& world, const PhotonMaps& maps, std::uint32_t pixel,
                                                std::uint32_t pass);

// The kinds of photons that carry light.
inline constexpr std::uint32_t kGlobalKinds =
    kindBit(PhotonKind::Direct) | kindBit(PhotonKind::Indirect) | kindBit(PhotonKind::Caustic);

// Options from the settings for estimates from the global and the caustic map, with their largest radius [m].
[[nodiscard]] RadianceEstimateOptions globalOptions(const World& world, double radius, std::uint32_t kinds);
[[nodiscard]] RadianceEstimateOptions causticOptions(const World& world, double radius);

// Follows a path through mirrors and glass to the first diffuse surface on each branch; sums what `visit` returns
// there.
template <class Visit>
void followPath(const World& world, const Ray& ray, const CameraPath& path, std::uint32_t depth, std::uint32_t index,
                const Visit& visit) {
    const std::optional<Hit> hit = traceClosest(world, ray);
    const Shading shading = hit ? shadeSurface(world, ray, *hit, path, depth, index) : shadeMiss(world, ray, path);
    visit(shading);
    for (const std::optional<NextRay>& next : shading.next) {
        if (next) {
            followPath(world, next->ray, next->path, depth + 1, index, visit);
        }
    }
}

} // namespace hyalite::reference
