// What makes an environment of the scene.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

namespace hyalite::kinds {

// A scene has at most one environment. Throws Error(BadInput) at the light that `reader` reads where it has one
// already.
void checkFirstEnvironment(const Reader& reader, const Scene& scene);

} // namespace hyalite::kinds
