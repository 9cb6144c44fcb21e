#include "cli/scene_settings.h"

#include "scene/model/integrators.h"
#include "scene/yaml/settings.h"

#include <algorithm>
#include <iterator>

namespace hyalite::cli {

std::vector<SceneSetting> allSettings(const std::vector<SceneSetting>& shorthands,
                                      const std::vector<std::string>& assignments) {
    std::vector<SceneSetting> settings;
    std::ranges::copy_if(shorthands, std::back_inserter(settings),
                         [](const SceneSetting& setting) { return setting.value.has_value(); });
    for (const std::string& text : assignments) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos) {
            throw Error(ExitCode::WrongUsage, "--set " + text + " has no value", "write --set key=value");
        }
        settings.push_back({"--set", text.substr(0, equals), text.substr(equals + 1)});
    }
    return settings;
}

void applySettings(Scene& scene, std::vector<SceneSetting> settings) {
    while (!settings.empty()) {
        std::vector<SceneSetting> refused;
        std::optional<Error> first;
        for (const SceneSetting& setting : settings) {
            try {
                applySetting(scene, setting.key, *setting.value, setting.option);
            } catch (const Error& error) {
                first = first ? first : error;
                refused.push_back(setting);
            }
        }
        if (refused.size() == settings.size()) {
            throw Error(*first);
        }
        settings = std::move(refused);
    }
}

std::string integratorHelp() {
    std::string text;
    for (const IntegratorRow& row : kIntegrators) {
        const bool isFirst = &row == kIntegrators.data();
        const bool isLast = &row + 1 == kIntegrators.data() + kIntegrators.size();
        text += (isFirst ? "" : isLast ? " or " : ", ") + std::string(row.name) + " (" + std::string(row.text) + ')';
    }
    return text;
}

} // namespace hyalite::cli
