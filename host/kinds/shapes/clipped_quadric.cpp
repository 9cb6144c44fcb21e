// See clipped_quadric.h.
#include "kinds/shapes/clipped_quadric.h"

#include "scene/model/bounds.h"
#include "scene/model/quadric.h"

#include <vector>

namespace hyalite::kinds {
namespace {

// Reads a corner of the clip box; a null coordinate leaves that side unbounded.
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

// Checks that the form has an inside and, without a capped box, an outside too. `written`: the place of the form.
void checkSurface(const Value& written, const std::optional<Value>& clip, const Quadric& quadric) {
    const glm::dvec3 far(kLargestLength);
    const Extremes q = extremes(quadric.form, intersection(quadric.clip, {-far, far}));
    const Value& place = clip ? *clip : written;
    const std::string within = clip ? " within its clip box" : "";
    if (!(q.least < 0)) {
        place.fail("this shape has no inside" + within + ": q is nowhere below 0", "inside is where q <= 0");
    }
    if (!(q.greatest > 0) && !(clip && quadric.capped)) {
        place.fail("this shape has no surface" + within + ": q is below 0 everywhere", "add a 'clip' box with caps");
    }
}

} // namespace

Shape clipped(Reader& reader, const Value& written, Quadric quadric) {
    const auto clip = reader.find(kClip.name);
    const auto caps = reader.find(kCaps.name);
    if (clip) {
        quadric.clip = readClip(*clip);
    }
    if (caps) {
        caps->read(quadric.capped);
        if (!clip) {
            caps->fail("'caps' needs a clip box, and this shape has none", "add a 'clip'");
        }
    }
    reader.finish();
    checkSurface(written, clip, quadric);
    quadric = withFiniteClip(quadric);
    checkReach(reader, worldBounds(quadric));
    return quadric;
}

} // namespace hyalite::kinds
