// See read_materials.h. The known materials are the rows of kinds/materials/material_kinds.h.
#include "scene/load/read_materials.h"

#include "kinds/materials/material_kinds.h"

#include <vector>

namespace hyalite {

Material readMaterial(const Value& value, const Scene& scene) {
    std::vector<Choice<const kinds::MaterialKind*>> choices;
    for (const kinds::MaterialKind* kind : kinds::kMaterialKinds) {
        choices.push_back({kind->doc.type, kind});
    }
    Reader reader(value);
    const auto* kind = choose<const kinds::MaterialKind*>(reader.require("type"), "material type", choices);
    Material material;
    material.name = value.name();
    material.where = value.where();
    material.model = kind->read(reader, scene, material);
    reader.finish();
    return material;
}

} // namespace hyalite
