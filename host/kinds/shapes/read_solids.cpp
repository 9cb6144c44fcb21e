// See read_solids.h.
#include "kinds/shapes/read_solids.h"

#include "scene/model/bounds.h"
#include "scene/model/named_quadrics.h"
#include "scene/model/quadric.h"

#include <algorithm>
#include <cmath>

namespace hyalite {
namespace {

constexpr Range kEndRadius{0, kLargestLength, true, true, "m"};

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

// The segment from `base` to `top` that cylinders and cones stand on.
struct Segment {
    glm::dvec3 base{0};
    glm::dvec3 axis{0, 1, 0}; // unit
    double height = 0;
};

Segment readSegment(Reader& reader) {
    Segment segment;
    const Value topValue = reader.require("top");
    glm::dvec3 top(0);
    reader.required("base", segment.base, kCoordinate);
    topValue.read(top, kCoordinate);
    segment.height = glm::length(top - segment.base);
    if (!(segment.height >= kSmallestLength)) {
        topValue.fail("'top' and 'base' are the same point");
    }
    segment.axis = (top - segment.base) / segment.height;
    return segment;
}

Shape stood(Reader& reader, const Placement& placement, const Segment& segment, Quadric solid, double thinnest) {
    bool isOpen = false;
    reader.optional("open", isOpen);
    solid.capped = !isOpen;
    solid.objectToWorld = placed(placement, segment.base, segment.axis) * solid.objectToWorld;
    checkThickness(placement, std::min(thinnest, segment.height));
    checkReach(reader, worldBounds(solid));
    return solid;
}

} // namespace

Shape readSphere(Reader& reader, const Placement& placement) {
    Sphere sphere;
    reader.optional("center", sphere.center, kCoordinate);
    reader.required("radius", sphere.radius, kLength);
    checkThickness(placement, sphere.radius);

    const auto scale = uniformScale(placement.objectToWorld);
    if (!scale) {
        const Quadric ellipsoid{.form = ellipsoidForm(glm::dvec3(sphere.radius)),
                                .objectToWorld = placed(placement, sphere.center)};
        checkReach(reader, worldBounds(ellipsoid));
        return ellipsoid;
    }
    sphere.center = transformPoint(placement.objectToWorld, sphere.center);
    sphere.radius *= *scale;
    checkReach(reader, worldBounds(sphere));
    return sphere;
}

Shape readBox(Reader& reader, const Placement& placement) {
    glm::dvec3 low(0);
    glm::dvec3 high(0);
    reader.required("min", low, kCoordinate);
    const Value highValue = reader.require("max");
    highValue.read(high, kCoordinate);
    const glm::dvec3 size = high - low;
    const double thinnest = std::min({size.x, size.y, size.z});
    if (!(thinnest >= kSmallestLength)) {
        highValue.fail("each coordinate of 'max' must be above that of 'min'");
    }
    Quadric box = boxQuadric(size / 2.0);
    box.objectToWorld = placed(placement, low + size / 2.0);
    checkThickness(placement, thinnest);
    checkReach(reader, worldBounds(box));
    return box;
}

Shape readCylinder(Reader& reader, const Placement& placement) {
    double radius = 0;
    const Segment segment = readSegment(reader);
    reader.required("radius", radius, kLength);
    return stood(reader, placement, segment, cylinderQuadric(radius, segment.height), radius);
}

Shape readCone(Reader& reader, const Placement& placement) {
    double radius = 0;
    double topRadius = 0;
    const Segment segment = readSegment(reader);
    reader.required("radius", radius, kEndRadius);
    reader.optional("top_radius", topRadius, kEndRadius);
    const double largest = std::max(radius, topRadius);
    if (!(largest >= kSmallestLength)) {
        reader.require("radius").fail("one of 'radius' and 'top_radius' must be " + kLength.text());
    }
    return stood(reader, placement, segment, coneQuadric(radius, topRadius, segment.height), largest);
}

Shape readTorus(Reader& reader, const Placement& placement) {
    Torus torus;
    glm::dvec3 center(0);
    reader.optional("center", center, kCoordinate);
    const glm::dvec3 axis = readAxis(reader);
    reader.required("major", torus.major, kLength);
    const Value minor = reader.require("minor");
    minor.read(torus.minor, kLength);
    if (!(torus.minor < torus.major)) {
        minor.fail("'minor' must be less than 'major', " + numberText(torus.major) + " m",
                   "the ring would run through its own axis");
    }
    torus.objectToWorld = placed(placement, center, axis);
    checkThickness(placement, torus.minor);
    checkReach(reader, worldBounds(torus));
    return torus;
}

} // namespace hyalite
