// Scenes far from the origin of their coordinates, as in survey data: moved near it before anything becomes a float.
#pragma once

#include "scene/model/scene.h"

namespace hyalite {

// The place to move to zero for things about `extent` [m] in size near `center` [m]: a multiple, along each axis, of
// the first of 1, 2, 5, 10, 20, ... (or 0.5, 0.2, ...) that is at least 16 extents. So it is zero for what lies within
// eight extents of zero, whose numbers keep their bits, and elsewhere the coordinates that are left have at most a few
// digits less than the things' own.
[[nodiscard]] glm::dvec3 originNear(const glm::dvec3& center, double extent);

// Sets Scene::origin and moves camera, lights, objects and leaves, so that they are relative to it. The place is the
// point of the box around all bounded objects that is nearest to the camera, because there a float should resolve most;
// the extent is half the box's diagonal or the distance from the camera to the point it looks at, whichever is less.
void recentre(Scene& scene);

// The camera in world coordinates, as settings give it; and back.
[[nodiscard]] Camera inWorld(const Camera& camera, const Scene& scene);
[[nodiscard]] Camera inScene(const Camera& camera, const Scene& scene);

} // namespace hyalite
