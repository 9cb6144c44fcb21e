// The cylinder: a quadric between two caps.
#include "kinds/shapes/segment.h"
#include "kinds/shapes/shape_kinds.h"
#include "scene/model/named_quadrics.h"
#include "scene/model/quadric.h"

#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kRadius{.name = "radius", .range = kLength, .required = true};
constexpr std::array kKeys{kBase, kTop, kRadius, kOpen};

Shape read(Reader& reader, const Surroundings& around) {
    double radius = 0;
    const Segment segment = readSegment(reader);
    readKey(reader, kRadius, radius);
    return stood(reader, around.placement, segment, cylinderQuadric(radius, segment.height), radius);
}

} // namespace

constinit const ShapeKind kCylinderShape{
    .doc = {.type = "cylinder",
            .schemaName = "cylinder",
            .text = "The points within `radius` of the axis, between its ends `base` and `top`.",
            .keys = kKeys},
    .read = read};

} // namespace hyalite::kinds
