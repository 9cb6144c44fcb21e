// The scene file's shapes without a volume, and the plane; all come back in world space.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/read_placement.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// The keys of one shape. Throw Error(BadInput).
[[nodiscard]] Shape readQuad(Reader& reader, const Placement& placement);
[[nodiscard]] Shape readDisk(Reader& reader, const Placement& placement);
[[nodiscard]] Shape readPlane(Reader& reader, const Placement& placement);

} // namespace hyalite
