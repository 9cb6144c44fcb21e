// Search radii from the density of photons: progressive photon mapping's first one, from a few photons traced
// beforehand, and the largest one of photon mapping's estimates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace hyalite {

// Photons emitted to estimate a radius; if fewer than kFewPhotons of them land, all photons of a pass are.
inline constexpr std::uint32_t kPilotPhotons = 8192;
inline constexpr std::size_t kFewPhotons = 40;

// Number of photons that a typical search of the first pass should find: among photons that arrive via diffuse
// surfaces, and among those of caustics, which have edges.
inline constexpr double kPhotonsPerSearch = 30;
inline constexpr double kCausticPhotonsPerSearch = 12;

// Median of the distances from each point to its k-th nearest other point [the unit of the points]: points that are
// scattered far around do not change it as long as most are crowded. There must be more than k points.
[[nodiscard]] double typicalSpacing(std::span<const glm::dvec3> points, std::size_t k);

// Bounds on radii.
struct RadiusBounds {
    double sceneRadius = 0; // of the scene's bounding sphere [m]: a radius is at most 1/20 of it
    glm::dvec3 eye{0};      // the camera [m]
    double footprint = 0;   // caustics: width of a pixel over the distance from the eye, the least radius around a
                            // photon, because camera rays would miss a smaller disc in a focus; others: 0
};

// The radius [m] within which about `wanted` of the photons of a pass of `emitted` photons lie around a typical one of
// them, estimated from `pilot`, the positions where photons of `pilotEmitted` emitted ones landed. It depends on them
// and not on the size of the scene: a small caustic on a large ground has a small radius. Rounded to an eighth of a
// power of two, so that pilots that differ by a rounding give the same. 1/100 of the scene's radius where fewer than
// four landed.
[[nodiscard]] double searchRadiusFor(double wanted, std::span<const glm::dvec3> pilot, std::uint32_t pilotEmitted,
                                     std::uint32_t emitted, const RadiusBounds& bounds);

// Photon mapping's largest radius [m] for estimates from the `nearest` ones of `photons`: four times the radius that
// holds as many around a typical one of them, or covers a pixel. Where photons are less than a sixteenth as dense as
// there, an estimate uses fewer. In the dark it looks no farther for light, and less far with more photons. At most
// `largest` [m]. Rounded as above.
[[nodiscard]] double largestEstimateFor(std::size_t nearest, std::span<const glm::dvec3> photons, double largest,
                                        const RadiusBounds& bounds);

} // namespace hyalite
