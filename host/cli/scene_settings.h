// Options of the command line that set keys of the scene file: they come from the table of settings.
#pragma once

#include "scene/yaml/settings.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace hyalite::cli {

// An option that stands for a key of the scene file.
struct SceneSetting {
    std::string option; // e.g. "--photons"
    std::string key;    // "render.photons"
    std::optional<std::string> value = {};
};

// What a command is told about settings: options that stand for a key, and --set.
struct SettingOptions {
    std::vector<SceneSetting> shorthands;
    std::vector<std::string> assignments; // key=value

    // The shorthands are those of the table of settings, without the options named.
    explicit SettingOptions(std::initializer_list<std::string_view> without = {});

    // Adds all options to the command; they write into this object, which must outlive the parsing.
    void addTo(CLI::App& app);

    // The shorthands that were given, then the assignments. Throws Error(WrongUsage) where one has no value.
    [[nodiscard]] std::vector<SettingAssignment> given() const;
};

// "render.radius=0.01" of --set. Throws Error(WrongUsage) where it has no value.
[[nodiscard]] SettingAssignment parseAssignment(const std::string& text);

// "ppm (progressive photon mapping), … or path (path tracing, unbiased)".
[[nodiscard]] std::string integratorHelp();

} // namespace hyalite::cli
