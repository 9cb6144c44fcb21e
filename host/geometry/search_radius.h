// Progressive photon mapping's first search radius, from the density of a few photons traced beforehand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace hyalite {

// Most photons emitted to estimate a radius.
inline constexpr std::uint32_t kPilotPhotons = 8192;

// Number of photons that a typical search of the first pass should find: among photons that arrive via diffuse
// surfaces, and among those of caustics, which have edges.
inline constexpr double kPhotonsPerSearch = 30;
inline constexpr double kCausticPhotonsPerSearch = 12;

// Geometric mean of the distances from each point to its k-th nearest other point [the unit of the points]: where some
// points are crowded and others scattered, as in a focus and around it, between the two. There must be more than k
// points.
[[nodiscard]] double typicalSpacing(std::span<const glm::dvec3> points, std::size_t k);

// The radius [m] within which about `wanted` of the photons of a pass of `emitted` photons lie around a typical one of
// them, estimated from `pilot`, the positions where photons of `pilotEmitted` emitted ones landed. Rounded to an eighth
// of a power of two, so that pilots that differ by a rounding give the same. At least 1/2000 and at most 1/20 of
// `sceneRadius` [m], the radius of the scene's bounding sphere; where hardly any photon landed, 1/100.
[[nodiscard]] double searchRadiusFor(double wanted, std::span<const glm::dvec3> pilot, std::uint32_t pilotEmitted,
                                     std::uint32_t emitted, double sceneRadius);

} // namespace hyalite
