// A closed room as one mesh: bumpy walls, pillars and balls.
#pragma once

#include "scene/model/scene.h"

namespace hyalite::bench {

// 121 088 triangles; the room is [-4, 4] x [0, 4] x [-4, 4] m.
[[nodiscard]] Mesh makeMeshRoom();

} // namespace hyalite::bench
