// The surface that a path meets, with the media on its two sides. Where a dielectric touches other objects, that is all
// surfaces at the place at once.
#pragma once

#include "reference/media/medium.h"
#include "reference/world.h"

namespace hyalite::reference {

struct Boundary : Surface {
    Media beyond;             // on the side opposite the path
    std::uint32_t object = 0; // of the world
};

// The surface at the ray's hit. If an opaque surface is within rounding of it, that one is met; else what is left there
// is left before anything is entered, the larger objects first. `media`: around the ray.
[[nodiscard]] Boundary boundaryAt(const World& world, const Ray& ray, const Hit& hit, const Media& media);

// Surfaces closer than this times the largest coordinate, of the place or of the smaller object, touch.
inline constexpr double kTouching = 0x1p-17;

// The object's surface at a place on another's, if it touches there.
[[nodiscard]] std::optional<Surface> touchingSurface(const World& world, const Neighbor& neighbor,
                                                     const Surface& place);

} // namespace hyalite::reference
