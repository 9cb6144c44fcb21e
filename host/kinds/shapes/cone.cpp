// The cone or truncated cone: a quadric between two caps.
#include "kinds/shapes/segment.h"
#include "kinds/shapes/shape_kinds.h"
#include "scene/model/named_quadrics.h"
#include "scene/model/quadric.h"

#include <algorithm>
#include <array>

namespace hyalite::kinds {
namespace {

constexpr Range kEndRadius{0, kLargestLength, true, true, "m"};
constexpr KeyDoc kRadius{.name = "radius", .range = kEndRadius, .required = true, .text = "radius at the base"};
constexpr KeyDoc kTopRadius{.name = "top_radius",
                            .range = kEndRadius,
                            .defaultText = "0",
                            .text = "radius at the top; one of the two must be at least 1e-9"};
constexpr std::array kKeys{kBase, kTop, kRadius, kTopRadius, kOpen};

Shape read(Reader& reader, const Surroundings& around) {
    double radius = 0;
    double topRadius = 0;
    const Segment segment = readSegment(reader);
    readKey(reader, kRadius, radius);
    readKey(reader, kTopRadius, topRadius);
    const double largest = std::max(radius, topRadius);
    if (!(largest >= kSmallestLength)) {
        reader.require(kRadius.name).fail("one of 'radius' and 'top_radius' must be " + kLength.text());
    }
    return stood(reader, around.placement, segment, coneQuadric(radius, topRadius, segment.height), largest);
}

} // namespace

constinit const ShapeKind kConeShape{
    .doc = {.type = "cone",
            .schemaName = "cone",
            .text = "A cylinder whose radius changes linearly from `radius` at the base to `top_radius` at the top.",
            .keys = kKeys},
    .read = read};

} // namespace hyalite::kinds
