// The torus. Device: shaders/shapes/torus.glsl; reference: host/reference/shapes/torus.cpp.
#include "base/numbers.h"
#include "kinds/shapes/object_record.h"
#include "kinds/shapes/shape_kinds.h"
#include "scene/model/bounds.h"
#include "scene/yaml/read_placement.h"

#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kCenter{.name = "center", .type = KeyType::Vector, .range = kCoordinate, .defaultText = "[0, 0, 0]"};
constexpr KeyDoc kAxis{.name = "axis",
                       .type = KeyType::Vector,
                       .range = kDirection,
                       .defaultText = "[0, 1, 0]",
                       .text = "direction of the shape's y axis, any nonzero length"};
constexpr KeyDoc kMajor{
    .name = "major", .range = kLength, .required = true, .text = "distance from the axis to the middle of the tube"};
constexpr KeyDoc kMinor{.name = "minor",
                        .range = kLength,
                        .required = true,
                        .text = "radius of the tube, below `major`",
                        .rangeText = "[1e-9, `major`)"};
constexpr std::array kKeys{kCenter, kAxis, kMajor, kMinor};

Shape read(Reader& reader, const Surroundings& around) {
    Torus torus;
    glm::dvec3 center(0);
    readKey(reader, kCenter, center);
    const glm::dvec3 axis = readAxis(reader);
    readKey(reader, kMajor, torus.major);
    const Value minor = reader.require(kMinor.name);
    minor.read(torus.minor, kMinor.range);
    if (!(torus.minor < torus.major)) {
        minor.fail("'minor' must be less than 'major', " + numberText(torus.major) + " m",
                   "otherwise the tube would intersect the axis");
    }
    torus.objectToWorld = placed(around.placement, center, axis);
    checkThickness(around.placement, torus.minor);
    checkReach(reader, worldBounds(torus));
    return torus;
}

} // namespace

ObjectRecord record(const Torus& torus, ObjectTables& /*tables*/) {
    ObjectRecord r{.type = shared::kShapeTorus};
    setLocalSpace(r, torus.objectToWorld, glm::dvec3(0));
    r.texels[4] = glm::dvec4(torus.major, torus.minor, 0, 0);
    return r;
}

constinit const ShapeKind kTorusShape{
    .doc = {.type = "torus",
            .schemaName = "torus",
            .text = "A ring: the points within `minor` of a circle of radius `major` about the axis. About the y axis, "
                    "(√(x² + z²) - `major`)² + y² ≤ `minor`².",
            .keys = kKeys},
    .read = read};

} // namespace hyalite::kinds
