// Spatial lookup of a pass's photons [Jensen01], and the density estimate from those near a visible point.
#pragma once

#include "reference/lights/lights.h"
#include "reference/photons/photons.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace hyalite::reference {

class PhotonMap {
public:
    explicit PhotonMap(std::vector<Photon> photons);
    ~PhotonMap();
    PhotonMap(PhotonMap&&) noexcept;
    PhotonMap& operator=(PhotonMap&&) noexcept;
    PhotonMap(const PhotonMap&) = delete;
    PhotonMap& operator=(const PhotonMap&) = delete;

    [[nodiscard]] const std::vector<Photon>& photons() const;

    // Indices of the photons with |p - x|^2 <= radius^2, ascending.
    [[nodiscard]] std::vector<std::uint32_t> near(const glm::dvec3& x, double radius) const;

    struct Neighbour {
        double distance2 = 0; // [m^2]
        std::uint32_t index = 0;
    };
    // The `count` nearest of the accepted photons with |p - x|^2 <= radius^2, ascending by distance and index.
    [[nodiscard]] std::vector<Neighbour> nearest(const glm::dvec3& x, std::size_t count, double radius,
                                                 const std::function<bool(const Photon&)>& accept) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

// Area [m^2] of the part of a disc, in the parallelogram's plane and centred on it, that lies within the parallelogram;
// at least 1/1024 of the disc's.
[[nodiscard]] double discOnQuad(const Quad& quad, const glm::dvec3& center, double radius);

// Area [m^2] of the part of the disc around x that lies on its surface: exact on parallelograms and round disks (at
// least 1/1024 of the disc's), elsewhere the whole disc.
[[nodiscard]] double discOnSurface(const VisiblePoint& x, double radius);
// Does a place near x lie within the edges of the parallelogram or round disk under x? True on other shapes.
[[nodiscard]] bool isWithinEdges(const VisiblePoint& x, const glm::dvec3& place);

// Could a photon have landed on the surface of x? Its normal is within 60 degrees of that of x, and the chord
// from x to it makes opposite angles with the two tangent planes, as on a plane or a sphere: half of the sum of its
// heights over them is at most the chord's length times hypot(0.004, sine of the angle between the normals), and 0.001
// times the length where the normals differ by no more than the device's rounding of them. Both positions may be off
// the surface by `surfaceError` and a share of 2^-19 of the largest coordinate of x [m].
[[nodiscard]] bool isOnSurface(const Photon& photon, const VisiblePoint& x, double surfaceError);
// … and have arrived on its side?
[[nodiscard]] bool isOnSide(const Photon& photon, const VisiblePoint& x, double surfaceError);

// The irradiance [W/m^2] of the nearest record on the surface of y, within `radius` [m], whose own disc holds y; none:
// no record does.
[[nodiscard]] std::optional<glm::dvec3> recordedIrradiance(const PhotonMap& records, const VisiblePoint& y,
                                                           double radius, double surfaceError);

// Radiance [W/(m^2 sr)] that the photons about x add to the pixel: f * sum of power / discOnSurface. Counts photons
// within r that landed on the same side of the same surface, nearly in its plane, on paths of at most maxDepth
// segments.
[[nodiscard]] glm::dvec3 gatherRadiance(const PhotonMap& map, const VisiblePoint& x, double radius,
                                        std::uint32_t maxDepth, double surfaceError);

} // namespace hyalite::reference
