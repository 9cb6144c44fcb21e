// The scene file's `csg`: solids made of solids.
#pragma once

#include "scene/load/read_shapes.h"
#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// The keys of one csg; its leaves go to the end of Scene::csgLeaves. Throws Error(BadInput).
[[nodiscard]] Shape readCsg(Reader& reader, const Surroundings& around);

} // namespace hyalite
