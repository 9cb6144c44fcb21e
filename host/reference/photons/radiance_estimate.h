// Reflected radiance from the density of the nearest photons [Jensen01, ch. 7].
#pragma once

#include "reference/photons/photon_map.h"

namespace hyalite::reference {

using hyalite::PhotonFilter;

struct RadianceEstimateOptions {
    std::size_t nearest = 50;   // number of photons to find, at least 2
    double radius = 0;          // largest search radius [m]
    std::uint32_t kinds = 0;    // bit PhotonKind is set for every kind to count
    std::uint32_t maxDepth = 0; // limit on the segments of photon and camera path together
    PhotonFilter filter = PhotonFilter::None;
    double coneConstant = 1.1; // the cone's radius over the disc's, >= 1
    double maxChange = 0;      // relative change of the density at which the disc stops growing; 0: it never does
    double surfaceError = 0;   // of positions on surfaces [m]
    glm::dvec3 eye{0};         // the camera [m]
    double footprint = 0;      // least radius of a disc over its distance from there
};

struct RadianceEstimate {
    glm::dvec3 radiance{0}; // added to the pixel [W/(m^2 sr)]
    double radius = 0;      // of the disc used [m]
};

// Finds the nearest photons that landed on the visible point's side of a surface. If the radius holds the requested
// number, the farthest of them sets the disc's radius and is excluded; otherwise the disc has the full radius. Photons
// farther from the tangent plane than a quarter of the disc's radius do not count. If the disc would be smaller than a
// pixel, `footprint` times the distance from the eye, or than 2^-20 of the largest, it has that radius and all photons
// within count, more than the requested number. With maxChange, nested discs are compared: the first holds 8 photons,
// or as many as it takes to be no smaller than that, each next a quarter more (rounded up), and the next photon sets
// the disc's radius. If the density rises, or falls, monotonically from some disc on, by more than maxChange of the
// density in that disc, the estimate uses that disc. Density here is the flux near the plane, as seen from the whole
// disc and summed over the channels, divided by the square of the radius.
[[nodiscard]] RadianceEstimate estimateRadiance(const PhotonMap& map, const VisiblePoint& x,
                                                const RadianceEstimateOptions& options);

// A filter's weight at distance d from the centre of a disc of radius r, and its mean over the disc.
[[nodiscard]] double filterWeight(const RadianceEstimateOptions& options, double d, double r);
[[nodiscard]] double meanFilterWeight(const RadianceEstimateOptions& options);

} // namespace hyalite::reference
