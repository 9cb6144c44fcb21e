#include "render/film/render_identity.h"

#include <algorithm>

namespace hyalite::render {

std::string RenderIdentity::setting(const std::string& name) const {
    for (const auto& [key, value] : settings) {
        if (key == name) {
            return value;
        }
    }
    return {};
}

std::string difference(const RenderIdentity& there, const RenderIdentity& here) {
    const auto isSetIn = [](const RenderIdentity& identity, const std::string& name) {
        return std::ranges::any_of(identity.settings, [&](const auto& entry) { return entry.first == name; });
    };
    const bool sameNames = there.settings.size() == here.settings.size() &&
                           std::ranges::all_of(here.settings, [&](const auto& e) { return isSetIn(there, e.first); });
    if (!sameNames) {
        return "one is from a different version of the program";
    }
    for (const auto& [name, value] : here.settings) {
        if (there.setting(name) != value) {
            return name + " is " + there.setting(name) + " there and " + value + " here";
        }
    }
    return {};
}

} // namespace hyalite::render
