// The camera and the render settings: read from the scene file, and changed from the command line or the live page
// through the same rows (settings_table.h), so that all obey the same ranges.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

#include <span>
#include <string>

namespace hyalite {

// Reads the keys that are there over what the struct holds. Throws Error(BadInput).
void readCamera(const Value& value, Camera& camera);
void readRenderSettings(const Value& value, RenderSettings& render);

struct SettingAssignment {
    std::string key;              // dotted, such as render.photons
    std::string value;            // in YAML; a resolution may also be written 512x512
    std::string option = "--set"; // where it was given, for messages
};

// Makes all assignments, and checks only then what relates several settings: their order does not matter, but that
// the last of the same key counts. Throws Error(WrongUsage) naming the option, and leaves the scene as it was.
void applySettings(Scene& scene, std::span<const SettingAssignment> assignments);
void applySetting(Scene& scene, const std::string& key, const std::string& value, const std::string& option = "--set");

} // namespace hyalite
