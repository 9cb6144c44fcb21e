// The scene file's lights that are not objects.
#pragma once

#include "scene/reader.h"
#include "scene/scene.h"

namespace hyalite {

// One item of `lights:`, added to the scene. Throws Error(BadInput).
void readLight(const Value& value, Scene& scene);

} // namespace hyalite
