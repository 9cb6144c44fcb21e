// The named quadrics.
#include "scene/model/named_quadrics.h"
#include "kinds/shapes/clipped_quadric.h"
#include "kinds/shapes/shape_kinds.h"

#include <algorithm>
#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kCenter{.name = "center",
                         .type = KeyType::Vector,
                         .range = kCoordinate,
                         .defaultText = "[0, 0, 0]",
                         .text = "centre; of a paraboloid its vertex"};
constexpr KeyDoc kAxis{.name = "axis",
                       .type = KeyType::Vector,
                       .range = kDirection,
                       .defaultText = "[0, 1, 0]",
                       .text = "direction of the shape's y axis, any nonzero length"};
constexpr KeyDoc kRadii{.name = "radii",
                        .type = KeyType::Vector,
                        .range = kLength,
                        .required = true,
                        .text = "lengths along the shape's x, y and z axes",
                        .rangeText = "each [1e-9, 1e9]"};
constexpr std::array kKeys{kCenter, kAxis, kRadii, kClip, kCaps};

Shape readOfForm(Reader& reader, const Surroundings& around, QuadricForm (*formOf)(const glm::dvec3&)) {
    glm::dvec3 center(0);
    glm::dvec3 radii(0);
    readKey(reader, kCenter, center);
    const glm::dvec3 axis = readAxis(reader);
    const Value written = reader.require(kRadii.name);
    written.read(radii, kRadii.range);
    checkThickness(around.placement, std::min({radii.x, radii.y, radii.z}));
    return clipped(reader, written, {.form = formOf(radii), .objectToWorld = placed(around.placement, center, axis)});
}

template <QuadricForm (*formOf)(const glm::dvec3& radii)>
Shape read(Reader& reader, const Surroundings& around) {
    return readOfForm(reader, around, formOf);
}

} // namespace

constinit const ShapeKind kEllipsoidShape{.doc = {.type = "ellipsoid",
                                                  .schemaName = "namedQuadric",
                                                  .text = "x²/a² + y²/b² + z²/c² ≤ 1",
                                                  .keys = kKeys,
                                                  .rules = kCapsNeedClip},
                                          .read = read<ellipsoidForm>};

constinit const ShapeKind kParaboloidShape{
    .doc = {.type = "paraboloid",
            .schemaName = "namedQuadric",
            .text = "x²/a² + z²/c² ≤ y/b: a bowl that opens towards +y; `center` is its lowest point, its rim at "
                    "height b has half-axes a and c",
            .keys = kKeys,
            .rules = kCapsNeedClip},
    .read = read<paraboloidForm>};

constinit const ShapeKind kHyperboloidOneSheetShape{
    .doc = {.type = "hyperboloid_one_sheet",
            .schemaName = "namedQuadric",
            .text = "x²/a² - y²/b² + z²/c² ≤ 1: a waist with half-axes a and c, widening both ways",
            .keys = kKeys,
            .rules = kCapsNeedClip},
    .read = read<hyperboloidOneSheetForm>};

constinit const ShapeKind kHyperboloidTwoSheetsShape{
    .doc = {.type = "hyperboloid_two_sheets",
            .schemaName = "namedQuadric",
            .text = "x²/a² - y²/b² + z²/c² ≤ -1: two bowls, with their lowest points at y = b and y = -b",
            .keys = kKeys,
            .rules = kCapsNeedClip},
    .read = read<hyperboloidTwoSheetsForm>};

constinit const ShapeKind kHyperbolicParaboloidShape{
    .doc = {.type = "hyperbolic_paraboloid",
            .schemaName = "namedQuadric",
            .text = "y/b ≤ x²/a² - z²/c²: below a saddle that rises along x; its front faces +y",
            .keys = kKeys,
            .rules = kCapsNeedClip},
    .read = read<hyperbolicParaboloidForm>};

} // namespace hyalite::kinds
