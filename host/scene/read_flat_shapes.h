// The scene file's shapes without a volume, and the plane; all come back in world space.
#pragma once

#include "scene/read_placement.h"
#include "scene/reader.h"
#include "scene/scene.h"

namespace hyalite {

// The keys of one shape. Throw Error(BadInput).
[[nodiscard]] Shape readQuad(Reader& reader, const Placement& placement);
[[nodiscard]] Shape readDisk(Reader& reader, const Placement& placement);
[[nodiscard]] Shape readPlane(Reader& reader, const Placement& placement);

} // namespace hyalite
