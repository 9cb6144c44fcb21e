// See read_shapes.h. The known shapes are the rows of kinds/shapes/shape_kinds.h.
#include "scene/load/read_shapes.h"

#include "kinds/shapes/shape_kinds.h"
#include "scene/yaml/find_material.h"
#include "scene/yaml/read_transform.h"

#include <vector>

namespace hyalite {

Object readShape(const Value& value, const kinds::Surroundings& around) {
    std::vector<Choice<const kinds::ShapeKind*>> choices;
    for (const kinds::ShapeKind* kind : kinds::kShapeKinds) {
        choices.push_back({kind->doc.type, kind});
    }
    Reader reader(value);
    const kinds::ShapeKind& kind = *choose<const kinds::ShapeKind*>(reader.require("type"), "shape", choices);
    kinds::Surroundings inner = around;
    inner.parts = kind.makesParts ? around.parts : nullptr; // in a csg a mesh file is one solid
    if (const auto transform = reader.find(kinds::kShapeTransform.name)) {
        inner.placement = {readTransform(*transform, around.placement.objectToWorld), transform};
    }
    if (const auto name = reader.find(kinds::kShapeMaterial.name)) {
        inner.material = findMaterial(*name, around.scene);
    }
    Object object;
    object.where = reader.where();
    object.shape = kind.read(reader, inner);
    object.material = around.cutMaterial ? around.cutMaterial : inner.material;
    reader.finish();
    return object;
}

} // namespace hyalite
