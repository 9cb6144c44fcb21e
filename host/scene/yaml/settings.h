// Reads camera and render settings from the scene file, and changes them from the command line or the live page. All
// use the same rows (settings_table.h) and so the same ranges.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

#include <span>
#include <string>

namespace hyalite {

// Overwrites the members whose keys are present. Throws Error(BadInput).
void readCamera(const Value& value, Camera& camera);
void readRenderSettings(const Value& value, RenderSettings& render);

struct SettingAssignment {
    std::string key;              // dotted, such as render.photons
    std::string value;            // in YAML; a resolution may also be written 512x512
    std::string option = "--set"; // the option that gave it, for messages
};

// Makes all assignments, then checks the rules between settings. The order matters only for assignments to the same
// key: the last one wins. On an error, throws Error(WrongUsage) naming the option and leaves the scene unchanged.
void applySettings(Scene& scene, std::span<const SettingAssignment> assignments);
void applySetting(Scene& scene, const std::string& key, const std::string& value, const std::string& option = "--set");

} // namespace hyalite
