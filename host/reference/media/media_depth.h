// How deep dielectrics are nested.
#pragma once

#include "scene/model/scene.h"

namespace hyalite::reference {

// Throws Error(BadInput) if a place is found inside more dielectrics than a path's list holds. Looks at random places
// in the boxes of dielectrics, and only where so many boxes meet.
void checkMediaDepth(const Scene& scene);

} // namespace hyalite::reference
