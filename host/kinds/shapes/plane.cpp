// The infinite plane. Device: shaders/shapes/solids.glsl; reference: host/reference/shapes/geometry.cpp.
#include "kinds/shapes/object_record.h"
#include "kinds/shapes/shape_kinds.h"
#include "scene/model/bounds.h"
#include "scene/yaml/read_placement.h"

#include <array>
#include <cmath>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kPoint{.name = "point", .type = KeyType::Vector, .range = kCoordinate, .required = true};
constexpr KeyDoc kNormal{
    .name = "normal", .type = KeyType::Vector, .range = kDirection, .required = true, .text = "direction of the front"};
constexpr std::array kKeys{kPoint, kNormal};

Shape read(Reader& reader, const Surroundings& around) {
    Plane plane;
    readKey(reader, kPoint, plane.point);
    plane.normal = readUnit(reader.require(kNormal.name));

    // The normal stays perpendicular to all directions in the plane: it transforms by the inverse transpose.
    plane.point = transformPoint(around.placement.objectToWorld, plane.point);
    plane.normal =
        glm::normalize(glm::transpose(glm::inverse(glm::dmat3(around.placement.objectToWorld))) * plane.normal);
    checkReach(reader, Bounds{plane.point, plane.point});
    return plane;
}

} // namespace

ObjectRecord record(const Plane& plane, ObjectTables& /*tables*/) {
    const glm::dvec3 n = plane.normal;
    const glm::dvec3 across = glm::normalize(std::abs(n.x) < 0.5 ? glm::cross(n, glm::dvec3(1, 0, 0)) //
                                                                 : glm::cross(n, glm::dvec3(0, 1, 0)));
    return flatRecord(shared::kShapePlane, plane.point, across, glm::cross(n, across));
}

constinit const ShapeKind kPlaneShape{
    .doc = {.type = "plane",
            .schemaName = "plane",
            .text = "The infinite plane through `point`. In a `csg` it is the half-space behind it.",
            .keys = kKeys},
    .read = read};

} // namespace hyalite::kinds
