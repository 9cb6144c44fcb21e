// The scene file's solids of everyday use. They come back about their own centres, with the way there in their
// objectToWorld: the kernels' floats are finest near the origin.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/read_placement.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// The keys of one shape. Throw Error(BadInput).
[[nodiscard]] Shape readSphere(Reader& reader, const Placement& placement); // a Quadric where it is stretched
[[nodiscard]] Shape readBox(Reader& reader, const Placement& placement);
[[nodiscard]] Shape readCylinder(Reader& reader, const Placement& placement);
[[nodiscard]] Shape readCone(Reader& reader, const Placement& placement);
[[nodiscard]] Shape readTorus(Reader& reader, const Placement& placement);

} // namespace hyalite
