// The names of materials in a scene file.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// Index in Scene::materials of the material that `name` names. Throws Error(BadInput) where there is none.
[[nodiscard]] std::size_t findMaterial(const Value& name, const Scene& scene);

} // namespace hyalite
