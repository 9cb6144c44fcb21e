#include "live/messages/setting_rows.h"

#include "scene/model/recentre.h"
#include "scene/yaml/settings_table.h"

namespace hyalite::live {
namespace {

using Json = nlohmann::json;

Json kindOf(const KeyDoc& key) {
    if (key.type == KeyType::Word) {
        return key.words;
    }
    return key.type == KeyType::Number || key.type == KeyType::WholeNumber ? "number" : "text";
}

} // namespace

const std::string& settingsScript() {
    static const std::string script = [] {
        Json rows = Json::array();
        for (const Setting& setting : settingsTable()) {
            if (setting.label.empty()) {
                continue;
            }
            Json row{dottedName(setting), setting.label, kindOf(setting.doc)};
            if (const std::vector<std::string> readers = readersOf(setting.doc.name); !readers.empty()) {
                row.push_back(readers);
            }
            rows.push_back(std::move(row));
        }
        return "\"use strict\";\nconst SETTINGS = " + rows.dump() + ";\n";
    }();
    return script;
}

Json settingValues(const Scene& scene) {
    const Settings settings{inWorld(scene.camera, scene), scene.render};
    Json values = Json::object();
    for (const Setting& setting : settingsTable()) {
        if (!setting.label.empty()) {
            values[dottedName(setting)] = setting.text(settings);
        }
    }
    return values;
}

} // namespace hyalite::live
