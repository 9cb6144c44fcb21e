// Solids on the segment from `base` to `top`: cylinders and cones.
#pragma once

#include "kinds/shapes/shape_kind.h"
#include "scene/model/scene.h"
#include "scene/yaml/read_placement.h"

namespace hyalite::kinds {

inline constexpr KeyDoc kBase{
    .name = "base", .type = KeyType::Vector, .range = kCoordinate, .required = true, .text = "one end of the axis"};
inline constexpr KeyDoc kTop{.name = "top",
                             .type = KeyType::Vector,
                             .range = kCoordinate,
                             .required = true,
                             .text = "the other end; must differ from `base`"};
inline constexpr KeyDoc kOpen{
    .name = "open", .type = KeyType::Flag, .defaultText = "false", .text = "leave off the caps at both ends"};

struct Segment {
    glm::dvec3 base{0};
    glm::dvec3 axis{0, 1, 0}; // unit
    double height = 0;        // [m]
};

// Reads the keys `base` and `top`. Throws Error(BadInput).
[[nodiscard]] Segment readSegment(Reader& reader);

// Moves a solid with axis y onto the segment and reads the key `open`. `thinnest`: its least extent across the axis
// [m]. Throws Error(BadInput).
[[nodiscard]] Shape stood(Reader& reader, const Placement& placement, const Segment& segment, Quadric solid,
                          double thinnest);

} // namespace hyalite::kinds
