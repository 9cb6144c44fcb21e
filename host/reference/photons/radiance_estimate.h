// Reflected radiance from the density of the nearest photons [Jensen01, ch. 7].
#pragma once

#include "reference/photons/photon_map.h"

namespace hyalite::reference {

using hyalite::PhotonFilter;

struct RadianceEstimateOptions {
    std::size_t nearest = 50;   // photons that are looked for, at least 2
    double radius = 0;          // none farther away [m]
    std::uint32_t kinds = 0;    // bit PhotonKind is set for every kind that counts
    std::uint32_t maxDepth = 0; // segments of the photon's path and the camera's together
    PhotonFilter filter = PhotonFilter::None;
    double coneConstant = 1.1; // the cone's radius over the disc's, >= 1
    double maxChange = 0;      // relative change of the density at which discs stop to grow; 0: they do not
};

struct RadianceEstimate {
    glm::dvec3 radiance{0}; // added to the pixel [W/(m^2 sr)]
    double radius = 0;      // of the disc it comes from [m]
};

// Looks for the nearest photons that landed on the visible point's side of a surface. If as many as asked for are
// within the radius, the farthest of them ends the disc and is left out, else the disc has the radius. Photons off the
// tangent plane by more than a quarter of the disc's radius do not count. A disc's radius is never below 1/1024 of the
// largest.
//
// With maxChange, discs of 8 photons, then a quarter more each time (rounded up), are compared, each ended by the next
// photon. Where the density has risen, or has fallen, from one to the next all the way from some disc on, and by more
// than maxChange of what it was in that one, that disc is taken. Density here is the channels' sum of the flux that is
// near the plane, as seen from the whole disc, over the square of the radius.
[[nodiscard]] RadianceEstimate estimateRadiance(const PhotonMap& map, const VisiblePoint& x,
                                                const RadianceEstimateOptions& options);

// A filter's weight at distance d from the centre of a disc of radius r, and its mean over the disc.
[[nodiscard]] double filterWeight(const RadianceEstimateOptions& options, double d, double r);
[[nodiscard]] double meanFilterWeight(const RadianceEstimateOptions& options);

} // namespace hyalite::reference
