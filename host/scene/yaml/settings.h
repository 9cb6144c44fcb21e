// The camera and the render settings: read from the scene file, and changed one by one from the command line through
// the same readers, so that both obey the same ranges.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// Reads the keys that are there over what the struct holds. Throws Error(BadInput).
void readCamera(const Value& value, Camera& camera);
void readRenderSettings(const Value& value, RenderSettings& render);

// Sets one dotted key, such as render.photons or camera.resolution, to a value in YAML; a resolution may also be
// written 512x512. Throws Error(WrongUsage) naming `option` and leaves the scene as it was. The range of
// render.max_depth depends on the integrator: when both change, set the integrator first.
void applySetting(Scene& scene, const std::string& key, const std::string& value, const std::string& option = "--set");

} // namespace hyalite
