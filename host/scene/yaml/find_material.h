// Finds a material by its name in the scene file.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// Index in Scene::materials of the material with this name. Throws Error(BadInput) if there is none.
[[nodiscard]] std::size_t findMaterial(const Value& name, const Scene& scene);

} // namespace hyalite
