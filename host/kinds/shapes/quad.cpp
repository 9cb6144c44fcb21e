// The parallelogram. Device: shaders/shapes/solids.glsl; reference: host/reference/shapes/geometry.cpp.
#include "kinds/shapes/flat.h"
#include "kinds/shapes/object_record.h"
#include "kinds/shapes/shape_kinds.h"
#include "scene/model/bounds.h"
#include "scene/yaml/read_placement.h"

#include <array>
#include <vector>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kCorner{.name = "corner", .type = KeyType::Vector, .range = kCoordinate, .required = true};
constexpr KeyDoc kEdges{.name = "edges",
                        .type = KeyType::Other,
                        .range = kCoordinate,
                        .required = true,
                        .text = "edges from the corner; the front is the side to which edge 0 × edge 1 points",
                        .schema =
                            R"({"type": "array", "items": {"$ref": "#/$defs/vector"}, "minItems": 2, "maxItems": 2})",
                        .typeText = "two vectors",
                        .rangeText = "each 1e-9 or longer, not parallel"};
constexpr std::array kKeys{kCorner, kEdges};

Shape read(Reader& reader, const Surroundings& around) {
    Quad quad;
    readKey(reader, kCorner, quad.corner);
    const Value edges = reader.require(kEdges.name);
    const std::vector<Value> pair = edges.list(2);
    pair[0].read(quad.edge0, kEdges.range);
    pair[1].read(quad.edge1, kEdges.range);

    quad.corner = transformPoint(around.placement.objectToWorld, quad.corner);
    transformAxes(around.placement.objectToWorld, quad.edge0, quad.edge1);
    if (!(glm::length(quad.edge0) >= kSmallestLength && glm::length(quad.edge1) >= kSmallestLength)) {
        edges.fail("an edge of this quad has no length");
    }
    if (areParallel(quad.edge0, quad.edge1)) {
        edges.fail("the edges of this quad are parallel: it has no area");
    }
    checkReach(reader, worldBounds(quad));
    return quad;
}

} // namespace

ObjectRecord record(const Quad& quad, ObjectTables& /*tables*/) {
    return flatRecord(shared::kShapeQuad, quad.corner, quad.edge0, quad.edge1);
}

constinit const ShapeKind kQuadShape{
    .doc = {.type = "quad",
            .schemaName = "quad",
            .text = "A parallelogram. Its front is the side to which edge 0 × edge 1 points (right hand).",
            .keys = kKeys},
    .read = read,
    .isSolid = false};

} // namespace hyalite::kinds
