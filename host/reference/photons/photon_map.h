// Spatial lookup of a pass's photons [Jensen01], and the density estimate from those near a visible point.
#pragma once

#include "reference/lights/lights.h"
#include "reference/photons/photons.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
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

// Radiance [W/(m^2 sr)] that the photons about x add to the pixel: f * sum of power / A, where A is pi r^2 or, on a
// parallelogram, the area of the disc within it. Counts photons within r that landed on the same side of the same
// surface, nearly in its plane, on paths of at most maxDepth segments.
[[nodiscard]] glm::dvec3 gatherRadiance(const PhotonMap& map, const VisiblePoint& x, double radius,
                                        std::uint32_t maxDepth);

} // namespace hyalite::reference
