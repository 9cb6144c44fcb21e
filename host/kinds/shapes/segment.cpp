// See segment.h.
#include "kinds/shapes/segment.h"

#include "scene/model/bounds.h"
#include "scene/model/quadric.h"

#include <algorithm>

namespace hyalite::kinds {

Segment readSegment(Reader& reader) {
    Segment segment;
    const Value topValue = reader.require(kTop.name);
    glm::dvec3 top(0);
    readKey(reader, kBase, segment.base);
    topValue.read(top, kTop.range);
    segment.height = glm::length(top - segment.base);
    if (!(segment.height >= kSmallestLength)) {
        topValue.fail("'top' and 'base' are the same point");
    }
    segment.axis = (top - segment.base) / segment.height;
    return segment;
}

Shape stood(Reader& reader, const Placement& placement, const Segment& segment, Quadric solid, double thinnest) {
    bool isOpen = false;
    readKey(reader, kOpen, isOpen);
    solid.capped = !isOpen;
    solid.objectToWorld = placed(placement, segment.base, segment.axis) * solid.objectToWorld;
    checkThickness(placement, std::min(thinnest, segment.height));
    checkReach(reader, worldBounds(solid));
    return solid;
}

} // namespace hyalite::kinds
