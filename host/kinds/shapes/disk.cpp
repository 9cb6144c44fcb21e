// The disk; a transform may make it an ellipse. Device: shaders/shapes/solids.glsl; reference:
// host/reference/shapes/geometry.cpp.
#include "kinds/shapes/flat.h"
#include "kinds/shapes/object_record.h"
#include "kinds/shapes/shape_kinds.h"
#include "scene/model/bounds.h"
#include "scene/yaml/read_placement.h"

#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kCenter{.name = "center", .type = KeyType::Vector, .range = kCoordinate, .defaultText = "[0, 0, 0]"};
constexpr KeyDoc kNormal{
    .name = "normal", .type = KeyType::Vector, .range = kDirection, .required = true, .text = "direction of the front"};
constexpr KeyDoc kRadius{.name = "radius", .range = kLength, .required = true};
constexpr std::array kKeys{kCenter, kNormal, kRadius};

Shape read(Reader& reader, const Surroundings& around) {
    Disk disk;
    double radius = 0;
    readKey(reader, kCenter, disk.center);
    const glm::dvec3 normal = readUnit(reader.require(kNormal.name));
    readKey(reader, kRadius, radius);

    const glm::dmat3 turn = rotationFromY(normal); // z x x = y
    disk.center = transformPoint(around.placement.objectToWorld, disk.center);
    disk.axis0 = radius * turn[2];
    disk.axis1 = radius * turn[0];
    transformAxes(around.placement.objectToWorld, disk.axis0, disk.axis1);
    if (!(glm::length(disk.axis0) >= kSmallestLength && glm::length(disk.axis1) >= kSmallestLength) ||
        areParallel(disk.axis0, disk.axis1)) {
        around.placement.transform->fail("this transform flattens the disk to a line");
    }
    checkReach(reader, worldBounds(disk));
    return disk;
}

} // namespace

ObjectRecord record(const Disk& disk, ObjectTables& /*tables*/) {
    return flatRecord(shared::kShapeDisk, disk.center, disk.axis0, disk.axis1);
}

constinit const ShapeKind kDiskShape{
    .doc = {.type = "disk", .schemaName = "disk", .text = "", .keys = kKeys}, .read = read, .isSolid = false};

} // namespace hyalite::kinds
