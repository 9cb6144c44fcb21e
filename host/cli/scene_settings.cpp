#include "cli/scene_settings.h"

#include "scene/yaml/settings_table.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace hyalite::cli {
namespace {

std::string helpOf(const SceneSetting& shorthand) {
    for (const Setting& setting : settingsTable()) {
        if (dottedName(setting) != shorthand.key) {
            continue;
        }
        if (setting.option != shorthand.option) {
            return "same as " + std::string(setting.option);
        }
        std::string words;
        for (const std::string_view word : setting.doc.words) {
            words += (words.empty() ? "" : ", ") + std::string(word);
        }
        return words + (words.empty() ? "" : ": ") + plainText(setting.doc.text);
    }
    return {};
}

} // namespace

SettingOptions::SettingOptions(std::initializer_list<std::string_view> without) {
    for (const Setting& setting : settingsTable()) {
        if (!setting.option.empty() && std::ranges::find(without, setting.option) == without.end()) {
            shorthands.push_back({std::string(setting.option), dottedName(setting)});
        }
    }
}

void SettingOptions::addTo(CLI::App& app) {
    for (SceneSetting& shorthand : shorthands) {
        app.add_option(shorthand.option, shorthand.value, helpOf(shorthand));
    }
    app.add_option("--set", assignments, "set a key of the scene file, e.g. --set render.radius=0.01");
}

std::vector<SettingAssignment> SettingOptions::given() const {
    std::vector<SettingAssignment> settings;
    for (const SceneSetting& shorthand : shorthands) {
        if (shorthand.value) {
            settings.push_back({shorthand.key, *shorthand.value, shorthand.option});
        }
    }
    for (const std::string& text : assignments) {
        settings.push_back(parseAssignment(text));
    }
    return settings;
}

SettingAssignment parseAssignment(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
        throw Error(ExitCode::WrongUsage, "--set " + text + " has no value", "write --set key=value");
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

} // namespace hyalite::cli
