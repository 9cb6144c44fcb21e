// Progressive photon mapping with independent passes [Knaus11].
#pragma once

#include "image/image.h"
#include "reference/photons/photon_map.h"
#include "reference/render.h"
#include "reference/world.h"

#include <cstdint>
#include <optional>

namespace hyalite::reference {

// Photons of a pass, and their search radius [m].
struct ProgressiveMap {
    PhotonMap photons;
    double radius = 0;
};

// Caustic photons have their own map if the scene has specular surfaces and the settings request it.
struct ProgressiveMaps {
    ProgressiveMap global;
    std::optional<ProgressiveMap> caustic;
};

// Search radii [m], from the settings or from the density of a few photons. `caustic` is 0 without a caustic map.
struct SearchRadii {
    double global = 0;
    double caustic = 0;
};
[[nodiscard]] SearchRadii firstRadii(const World& world);

// Traces the photons of a pass, to be searched within `radii`.
[[nodiscard]] ProgressiveMaps traceProgressive(const World& world, const SearchRadii& radii, std::uint32_t pass);

// Radiance [W/(m^2 sr)] through a pixel in a pass.
[[nodiscard]] glm::dvec3 ppmRadiance(const World& world, const ProgressiveMaps& maps, std::uint32_t pixel,
                                     std::uint32_t pass);

// Squared search radius [m^2] of the pass after `pass` (counted from 0), given the squared radius of that pass.
[[nodiscard]] double nextRadius2(double radius2, std::uint32_t pass, double alpha);

[[nodiscard]] LayeredImage renderPpm(const World& world, const RenderOptions& options);

} // namespace hyalite::reference
