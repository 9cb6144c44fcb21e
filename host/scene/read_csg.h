// The scene file's `csg`: solids made of solids.
#pragma once

#include "scene/read_shapes.h"
#include "scene/reader.h"
#include "scene/scene.h"

namespace hyalite {

// The keys of one csg; its leaves go to the end of Scene::csgLeaves. Throws Error(BadInput).
[[nodiscard]] Shape readCsg(Reader& reader, const Surroundings& around);

} // namespace hyalite
