// Photon mapping in two passes [Jensen96, Jensen01]: photons from the lights into maps, then rays from the eye that ask
// the maps what they do not compute themselves.
#pragma once

#include "image/layered_image.h"
#include "reference/photon_map.h"
#include "reference/render.h"
#include "reference/world.h"

#include <cstdint>
#include <optional>

namespace hyalite::reference {

// Radiance through a pixel, by the way the light came to the last diffuse surface [W/(m^2 sr)].
struct LightComponents {
    glm::dvec3 emitted{0};  // seen itself, in mirrors and through glass too
    glm::dvec3 direct{0};   // straight from a light
    glm::dvec3 caustic{0};  // by way of mirrors and glass alone
    glm::dvec3 indirect{0}; // by way of another diffuse surface

    LightComponents& operator+=(const LightComponents& other);
};

struct PhotonMaps {
    PhotonMap global;                    // direct, indirect and caustic photons
    std::optional<PhotonMap> caustic;    // caustic photons alone; none: nothing specular, or none wanted
    std::optional<PhotonMap> shadow;     // direct and shadow photons
    std::optional<PhotonMap> irradiance; // every fourth photon of the global map, its power the irradiance [W/m^2]
};

[[nodiscard]] PhotonMaps buildPhotonMaps(const World& world);

[[nodiscard]] LightComponents photonMapRadiance(const World& world, const PhotonMaps& maps, std::uint32_t pixel,
                                                std::uint32_t pass);

[[nodiscard]] LayeredImage renderPhotonMap(const World& world, const RenderOptions& options);

} // namespace hyalite::reference
