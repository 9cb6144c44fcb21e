// See read_shapes.h. A new shape is a reader here (or in a file of its own) and a row of kShapes.
#include "scene/read_shapes.h"

#include "scene/bounds.h"
#include "scene/read_transform.h"
#include "scene/scene_limits.h"

#include <array>
#include <cmath>

namespace hyalite {
namespace {

constexpr Range kCoordinate{-kLargestLength, kLargestLength, true, true, "m"};
constexpr Range kRadius{kSmallestLength, kLargestLength, true, true, "m"};

// What a shape's reader knows besides the shape's own keys.
struct Placement {
    glm::dmat4 objectToWorld{1};
    const Value* transform = nullptr; // where it is written; null: nowhere
    MeshLibrary* meshes = nullptr;
};

glm::dvec3 transformPoint(const glm::dmat4& matrix, const glm::dvec3& point) {
    return matrix * glm::dvec4(point, 1);
}

bool isWithinLimits(const glm::dvec3& point) {
    return kCoordinate.contains(point.x) && kCoordinate.contains(point.y) && kCoordinate.contains(point.z);
}

[[noreturn]] void failTooFar(const Reader& reader) {
    throw Error(ExitCode::BadInput, reader.where(),
                "with its transform this shape reaches beyond " + numberText(kLargestLength) + " m",
                "scenes are in metres");
}

// The factor by which the map stretches every direction alike; none when it does not.
std::optional<double> uniformScale(const glm::dmat4& matrix) {
    const glm::dmat3 linear(matrix);
    const glm::dmat3 gram = glm::transpose(linear) * linear; // scale^2 times the identity
    const double squared = (gram[0][0] + gram[1][1] + gram[2][2]) / 3;
    constexpr double kTolerance = 1e-9; // relative; products of a few rotations err by 1e-15
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            const double expected = column == row ? squared : 0;
            if (!(std::abs(gram[column][row] - expected) <= kTolerance * squared)) {
                return std::nullopt;
            }
        }
    }
    return std::sqrt(squared);
}

Shape readSphere(Reader& reader, const Placement& placement) {
    Sphere sphere;
    reader.optional("center", sphere.center, kCoordinate);
    reader.required("radius", sphere.radius, kRadius);

    const auto scale = uniformScale(placement.objectToWorld);
    if (!scale) {
        placement.transform->fail("a sphere cannot be stretched or sheared",
                                  "scale it by one number; ellipsoids are not supported yet");
    }
    sphere.center = transformPoint(placement.objectToWorld, sphere.center);
    sphere.radius *= *scale;
    if (!isWithinLimits(sphere.center) || sphere.radius > kLargestLength) {
        failTooFar(reader);
    }
    if (sphere.radius < kSmallestLength) {
        placement.transform->fail("this transform leaves a sphere of radius " + numberText(sphere.radius) + " m");
    }
    return sphere;
}

Shape readQuad(Reader& reader, const Placement& placement) {
    Quad quad;
    reader.required("corner", quad.corner, kCoordinate);
    const Value edges = reader.require("edges");
    const std::vector<Value> pair = edges.list(2);
    pair[0].read(quad.edge0, kCoordinate);
    pair[1].read(quad.edge1, kCoordinate);

    const glm::dmat3 linear(placement.objectToWorld);
    quad.corner = transformPoint(placement.objectToWorld, quad.corner);
    quad.edge0 = linear * quad.edge0;
    quad.edge1 = linear * quad.edge1;
    if (glm::determinant(linear) < 0) {
        // A mirror image turns edge0 x edge1 round; swapping the edges keeps the front where the mirror put it.
        std::swap(quad.edge0, quad.edge1);
    }

    const double length0 = glm::length(quad.edge0);
    const double length1 = glm::length(quad.edge1);
    if (!(length0 >= kSmallestLength && length1 >= kSmallestLength)) {
        edges.fail("an edge of this quad has no length");
    }
    if (!(glm::length(glm::cross(quad.edge0 / length0, quad.edge1 / length1)) >= kSmallestAngle)) {
        edges.fail("the edges of this quad are parallel: it has no area");
    }
    if (!isWithinLimits(quad.corner) || !isWithinLimits(quad.edge0) || !isWithinLimits(quad.edge1)) {
        failTooFar(reader);
    }
    return quad;
}

Shape readMesh(Reader& reader, const Placement& placement) {
    const Value file = reader.require("file");
    reader.finish(); // before a large file is read for nothing
    const MeshInstance instance{placement.meshes->load(file), placement.objectToWorld};
    const Bounds box = meshBounds(placement.meshes->at(instance.mesh), instance.objectToWorld);
    if (!isWithinLimits(box.low) || !isWithinLimits(box.high)) {
        failTooFar(reader);
    }
    if (!(glm::length(box.high - box.low) >= kSmallestLength)) {
        file.fail("with its transform this mesh is a single point");
    }
    return instance;
}

using ReadShape = Shape (*)(Reader&, const Placement&);
constexpr std::array<Choice<ReadShape>, 3> kShapes{{
    {"sphere", readSphere},
    {"quad", readQuad},
    {"mesh", readMesh},
}};

} // namespace

Shape readShape(const Value& value, const std::optional<Value>& transform, MeshLibrary& meshes) {
    Placement placement{glm::dmat4(1), nullptr, &meshes};
    if (transform) {
        placement.objectToWorld = readTransform(*transform);
        placement.transform = &*transform;
    }
    Reader reader(value);
    const auto read = choose<ReadShape>(reader.require("type"), "shape", kShapes);
    Shape shape = read(reader, placement);
    reader.finish();
    return shape;
}

} // namespace hyalite
