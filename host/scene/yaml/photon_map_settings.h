// The keys of `render` that belong to integrator photonmap.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// Reads the keys that are there over what the struct holds. Throws Error(BadInput).
void readPhotonMapSettings(Reader& reader, PhotonMapSettings& settings);

} // namespace hyalite
