// Command line options that set keys of the scene file; made from the table of settings.
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

// An option that sets one key of the scene file.
struct SceneSetting {
    std::string option; // e.g. "--photons"
    std::string key;    // "render.photons"
    std::optional<std::string> value = {};
};

// A command's options for settings: one option per key, and --set.
struct SettingOptions {
    std::vector<SceneSetting> shorthands;
    std::vector<std::string> assignments; // key=value

    // Takes the options of the table of settings, except those in `without`.
    explicit SettingOptions(std::initializer_list<std::string_view> without = {});

    // Adds all options to the command. They write into this object, which must outlive the parsing.
    void addTo(CLI::App& app);

    // The given options, then the assignments of --set. Throws Error(WrongUsage) if one has no value.
    [[nodiscard]] std::vector<SettingAssignment> given() const;
};

// Parses an argument of --set, e.g. "render.radius=0.01". Throws Error(WrongUsage) if it has no value.
[[nodiscard]] SettingAssignment parseAssignment(const std::string& text);

} // namespace hyalite::cli
