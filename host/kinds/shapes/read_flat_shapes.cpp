// See read_flat_shapes.h.
#include "kinds/shapes/read_flat_shapes.h"

#include "scene/model/bounds.h"

#include <utility>

namespace hyalite {
namespace {

// The images of two axes that span a shape. A mirror image turns their cross product round; swapping them keeps the
// front where the mirror put it.
void transformAxes(const glm::dmat4& map, glm::dvec3& axis0, glm::dvec3& axis1) {
    const glm::dmat3 linear(map);
    axis0 = linear * axis0;
    axis1 = linear * axis1;
    if (glm::determinant(linear) < 0) {
        std::swap(axis0, axis1);
    }
}

bool areParallel(const glm::dvec3& a, const glm::dvec3& b) {
    return !(glm::length(glm::cross(glm::normalize(a), glm::normalize(b))) >= kSmallestAngle);
}

} // namespace

Shape readQuad(Reader& reader, const Placement& placement) {
    Quad quad;
    reader.required("corner", quad.corner, kCoordinate);
    const Value edges = reader.require("edges");
    const std::vector<Value> pair = edges.list(2);
    pair[0].read(quad.edge0, kCoordinate);
    pair[1].read(quad.edge1, kCoordinate);

    quad.corner = transformPoint(placement.objectToWorld, quad.corner);
    transformAxes(placement.objectToWorld, quad.edge0, quad.edge1);
    if (!(glm::length(quad.edge0) >= kSmallestLength && glm::length(quad.edge1) >= kSmallestLength)) {
        edges.fail("an edge of this quad has no length");
    }
    if (areParallel(quad.edge0, quad.edge1)) {
        edges.fail("the edges of this quad are parallel: it has no area");
    }
    checkReach(reader, worldBounds(quad));
    return quad;
}

Shape readDisk(Reader& reader, const Placement& placement) {
    Disk disk;
    double radius = 0;
    reader.optional("center", disk.center, kCoordinate);
    const glm::dvec3 normal = readUnit(reader.require("normal"));
    reader.required("radius", radius, kLength);

    const glm::dmat3 turn = rotationFromY(normal); // z x x = y
    disk.center = transformPoint(placement.objectToWorld, disk.center);
    disk.axis0 = radius * turn[2];
    disk.axis1 = radius * turn[0];
    transformAxes(placement.objectToWorld, disk.axis0, disk.axis1);
    if (!(glm::length(disk.axis0) >= kSmallestLength && glm::length(disk.axis1) >= kSmallestLength) ||
        areParallel(disk.axis0, disk.axis1)) {
        placement.transform->fail("this transform squashes the disk to a line");
    }
    checkReach(reader, worldBounds(disk));
    return disk;
}

Shape readPlane(Reader& reader, const Placement& placement) {
    Plane plane;
    reader.required("point", plane.point, kCoordinate);
    plane.normal = readUnit(reader.require("normal"));

    // A normal is to every direction within the plane what it was before: it goes by the inverse transpose.
    plane.point = transformPoint(placement.objectToWorld, plane.point);
    plane.normal = glm::normalize(glm::transpose(glm::inverse(glm::dmat3(placement.objectToWorld))) * plane.normal);
    checkReach(reader, Bounds{plane.point, plane.point});
    return plane;
}

} // namespace hyalite
