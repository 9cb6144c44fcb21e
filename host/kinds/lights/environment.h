// A check shared by the lights that become the scene's environment.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

namespace hyalite::kinds {

// Throws Error(BadInput) at the light that `reader` reads if the scene already has an environment.
void checkFirstEnvironment(const Reader& reader, const Scene& scene);

} // namespace hyalite::kinds
