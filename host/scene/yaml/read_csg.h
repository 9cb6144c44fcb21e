// The scene file's `csg`: solids made of solids.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/read_shapes.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// The keys of one csg; its leaves go to the end of Scene::csgLeaves. Throws Error(BadInput).
[[nodiscard]] Shape readCsg(Reader& reader, const Surroundings& around);

} // namespace hyalite
