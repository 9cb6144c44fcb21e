// The scene file's shapes of triangles: mesh files and the teapot.
#pragma once

#include "scene/load/read_shapes.h"
#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// The keys of one shape. Throw Error(BadInput).
[[nodiscard]] Shape readMesh(Reader& reader, const Surroundings& around);
[[nodiscard]] Shape readTeapot(Reader& reader, const Surroundings& around);

} // namespace hyalite
