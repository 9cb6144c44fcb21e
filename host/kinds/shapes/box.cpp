// The box: a quadric whose only surface is its clip box.
#include "kinds/shapes/shape_kinds.h"
#include "scene/model/bounds.h"
#include "scene/model/named_quadrics.h"
#include "scene/model/quadric.h"
#include "scene/yaml/read_placement.h"

#include <algorithm>
#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kMin{.name = "min", .type = KeyType::Vector, .range = kCoordinate, .required = true};
constexpr KeyDoc kMax{.name = "max",
                      .type = KeyType::Vector,
                      .range = kCoordinate,
                      .required = true,
                      .text = "at least 1e-9 above `min` in each coordinate"};
constexpr std::array kKeys{kMin, kMax};

Shape read(Reader& reader, const Surroundings& around) {
    glm::dvec3 low(0);
    glm::dvec3 high(0);
    readKey(reader, kMin, low);
    const Value highValue = reader.require(kMax.name);
    highValue.read(high, kMax.range);
    const glm::dvec3 size = high - low;
    const double thinnest = std::min({size.x, size.y, size.z});
    if (!(thinnest >= kSmallestLength)) {
        highValue.fail("each coordinate of 'max' must be above that of 'min'");
    }
    Quadric box = boxQuadric(size / 2.0);
    box.objectToWorld = placed(around.placement, low + size / 2.0);
    checkThickness(around.placement, thinnest);
    checkReach(reader, worldBounds(box));
    return box;
}

} // namespace

constinit const ShapeKind kBoxShape{.doc = {.type = "box",
                                            .schemaName = "box",
                                            .text = "An axis-aligned box from corner `min` to corner `max`.",
                                            .keys = kKeys},
                                    .read = read};

} // namespace hyalite::kinds
