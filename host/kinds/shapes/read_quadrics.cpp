// See read_quadrics.h.
#include "kinds/shapes/read_quadrics.h"

#include "scene/model/bounds.h"
#include "scene/model/quadric.h"

#include <algorithm>
#include <cmath>

namespace hyalite {
namespace {

// Of a coefficient: squares and products of them are far from the ends of a double's range.
constexpr double kLargestCoefficient = 1e30;
constexpr double kSmallestCoefficient = 1e-30;
constexpr Range kCoefficient{-kLargestCoefficient, kLargestCoefficient};

// A corner of the clip box; null leaves a side without end.
void readCorner(const Value& value, glm::dvec3& corner) {
    const std::vector<Value> coordinates = value.list(3);
    for (int axis = 0; axis < 3; ++axis) {
        const Value& coordinate = coordinates[static_cast<std::size_t>(axis)];
        if (coordinate.node().kind != YamlNode::Kind::Null) {
            coordinate.read(corner[axis], kCoordinate);
        }
    }
}

Bounds readClip(const Value& value) {
    Bounds clip = Bounds::everything();
    Reader reader(value);
    const auto low = reader.find("min");
    const auto high = reader.find("max");
    reader.finish();
    if (low) {
        readCorner(*low, clip.low);
    }
    if (high) {
        readCorner(*high, clip.high);
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!(clip.high[axis] - clip.low[axis] >= kSmallestLength)) {
            high->fail("each coordinate of 'max' must be above that of 'min'");
        }
    }
    if (low || high) {
        const Bounds all = Bounds::everything();
        if (clip.low != all.low || clip.high != all.high) {
            return clip;
        }
    }
    value.fail("this clip box has no side", "give 'min' or 'max' a coordinate that is not null");
}

// A form must have an inside and, without a box to close it, an outside too. `written` is where the form stands.
void checkSurface(const Value& written, const std::optional<Value>& clip, const Quadric& quadric) {
    const glm::dvec3 far(kLargestLength);
    const Extremes q = extremes(quadric.form, intersection(quadric.clip, {-far, far}));
    const Value& place = clip ? *clip : written;
    const std::string within = clip ? " within its clip box" : "";
    if (!(q.least < 0)) {
        place.fail("this shape has no inside" + within + ": q is nowhere below 0", "inside is where q <= 0");
    }
    if (!(q.greatest > 0) && !(clip && quadric.capped)) {
        place.fail("this shape has no surface" + within + ": q is below 0 everywhere",
                   "a 'clip' box with caps gives it one");
    }
}

// The keys that every quadric has, around the form that is its own.
Shape finished(Reader& reader, const Value& written, Quadric quadric) {
    const auto clip = reader.find("clip");
    const auto caps = reader.find("caps");
    if (clip) {
        quadric.clip = readClip(*clip);
    }
    if (caps) {
        caps->read(quadric.capped);
        if (!clip) {
            caps->fail("'caps' close a clip box, and this shape has none", "give it a 'clip'");
        }
    }
    reader.finish();
    checkSurface(written, clip, quadric);
    quadric = withFiniteClip(quadric);
    checkReach(reader, worldBounds(quadric));
    return quadric;
}

} // namespace

Shape readNamedQuadric(Reader& reader, const Placement& placement, QuadricForm (*formOf)(const glm::dvec3&)) {
    glm::dvec3 center(0);
    glm::dvec3 radii(0);
    reader.optional("center", center, kCoordinate);
    const glm::dvec3 axis = readAxis(reader);
    const Value written = reader.require("radii");
    written.read(radii, kLength);
    checkThickness(placement, std::min({radii.x, radii.y, radii.z}));
    return finished(reader, written, {.form = formOf(radii), .objectToWorld = placed(placement, center, axis)});
}

Shape readQuadric(Reader& reader, const Placement& placement) {
    const Value written = reader.require("coefficients");
    const std::vector<double> c = written.numbers(10, kCoefficient);
    const QuadricForm form{c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9]};
    const auto isSmall = [](double coefficient) { return std::abs(coefficient) < kSmallestCoefficient; };
    if (std::all_of(c.begin(), c.end(), isSmall)) {
        written.fail("all coefficients of this quadric are 0");
    }
    if (std::all_of(c.begin(), c.end() - 1, isSmall) && (form.j > 0 || !reader.find("clip"))) {
        written.fail("of these coefficients only the last is not 0: q is the same everywhere and has no surface",
                     "the order is a b c d e f g h i j; -1 as the last within a 'clip' makes a box");
    }
    return finished(reader, written, {.form = normalised(form), .objectToWorld = placement.objectToWorld});
}

} // namespace hyalite
