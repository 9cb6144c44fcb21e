// Options of the command line that set keys of the scene file.
#pragma once

#include "scene/model/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace hyalite::cli {

struct SceneSetting {
    std::string option; // that was given, for messages
    std::string key;    // e.g. "render.radius"
    std::optional<std::string> value;
};

// The shorthands that were given, then those of --set key=value. Throws Error(WrongUsage) where one has no value.
[[nodiscard]] std::vector<SceneSetting> allSettings(const std::vector<SceneSetting>& shorthands,
                                                    const std::vector<std::string>& assignments);

// Throws what applySetting throws. Settings may need one another (a depth of 0 suits one integrator only): what is
// refused is tried again after the rest.
void applySettings(Scene& scene, std::vector<SceneSetting> settings);

// "ppm (progressive photon mapping), … or path (path tracing, unbiased)".
[[nodiscard]] std::string integratorHelp();

} // namespace hyalite::cli
