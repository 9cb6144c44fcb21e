// The settings that the page shows: those of the table that have a label.
#pragma once

#include "scene/model/scene.h"

#include <nlohmann/json.hpp>
#include <string>

namespace hyalite::live {

// JavaScript that defines SETTINGS, a list of [key, label, kind, integrators that read it (absent: all)]; the kind is
// "number", "text" or a list of words.
[[nodiscard]] const std::string& settingsScript();

// The values by key, as texts that a scene file could hold.
[[nodiscard]] nlohmann::json settingValues(const Scene& scene);

} // namespace hyalite::live
